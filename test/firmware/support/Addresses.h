#pragma once

#include <framing/Address.h>

// Devices; the last two are next to each other.
const javino::Address ROMA(0x44e300);
const javino::Address SUPO(0x4943ce);
const javino::Address SUPP(0x4943cf);
