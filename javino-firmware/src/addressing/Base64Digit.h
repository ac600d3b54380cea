#pragma once

#include <stdint.h>

namespace javino {

/// The Base64 alphabet of RFC 4648 section 4: `A`…`Z`, `a`…`z`, `0`…`9`, `+`, `/` stand for 0…63.

static const uint8_t NOT_A_DIGIT = 0xFF;

/// @return the value 0…63 of a digit, or NOT_A_DIGIT.
uint8_t base64Value(uint8_t digit);

/// @param value 0…63
uint8_t base64Digit(uint8_t value);

}  // namespace javino
