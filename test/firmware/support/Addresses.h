#pragma once

#include <framing/Address.h>

#include <stdexcept>
#include <string>

// Devices; the last two are next to each other.
const javinolib::Address ROMA(0x44e300);
const javinolib::Address SUPO(0x4943ce);
const javinolib::Address SUPP(0x4943cf);

inline javinolib::Address addressOf(const std::string &text) {
  javinolib::Address address;
  if (!javinolib::Address::parse(reinterpret_cast<const uint8_t *>(text.data()), address))
    throw std::invalid_argument(text);
  return address;
}
