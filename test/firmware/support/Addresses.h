#pragma once

#include <framing/Address.h>

// Devices; the last two are next to each other.
const javinolib::Address ROMA(0x44e300);
const javinolib::Address SUPO(0x4943ce);
const javinolib::Address SUPP(0x4943cf);
