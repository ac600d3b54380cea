#pragma once

#include <stddef.h>
#include <stdint.h>

#include "Inlining.h"

namespace javinolib {

/// CRC-16/X-25 (SPEC 4.1): the check of serial and radio packets alike.
class Crc16 {
 public:
  Crc16() : value_(0) {}

  JAVINO_INLINE void add(const uint8_t *bytes, size_t length) { value_ = extend(value_, bytes, length); }

  /// The CRC of all bytes added so far; its low byte goes first on the line and on the air.
  uint16_t value() const { return value_; }

  /// By what the CRC of some bytes changes where one of them changes.
  /// @param bits of that byte that change
  /// @param following bytes behind it
  static uint16_t changeOf(uint8_t bits, uint8_t following);

 private:
  // The value in registers, not an object in memory.
  JAVINO_OUT_OF_LINE static uint16_t extend(uint16_t value, const uint8_t *bytes, size_t length);

  uint16_t value_;  // the complement of the remainder
};

}  // namespace javinolib
