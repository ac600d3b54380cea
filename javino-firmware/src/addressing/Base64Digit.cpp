#include "Base64Digit.h"

namespace javino {

uint8_t base64Value(uint8_t digit) {
  if (digit >= 'A' && digit <= 'Z') return static_cast<uint8_t>(digit - 'A');
  if (digit >= 'a' && digit <= 'z') return static_cast<uint8_t>(digit - 'a' + 26);
  if (digit >= '0' && digit <= '9') return static_cast<uint8_t>(digit - '0' + 52);
  if (digit == '+') return 62;
  if (digit == '/') return 63;
  return NOT_A_DIGIT;
}

uint8_t base64Digit(uint8_t value) {
  if (value < 26) return static_cast<uint8_t>('A' + value);
  if (value < 52) return static_cast<uint8_t>('a' + value - 26);
  if (value < 62) return static_cast<uint8_t>('0' + value - 52);
  return value == 62 ? '+' : '/';
}

}  // namespace javino
