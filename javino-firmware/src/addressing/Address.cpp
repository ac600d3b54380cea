#include "Address.h"

#include "Base64Digit.h"

namespace javino {

const uint8_t Address::TEXT_LENGTH;
const uint8_t Address::STORED_LENGTH;
const uint32_t Address::SERIAL_VALUE;

static const uint8_t PLUS = 62;
static const uint8_t SLASH = 63;

bool Address::parse(const uint8_t *text, Address &into) {
  uint32_t value = 0;
  for (uint8_t i = 0; i < TEXT_LENGTH; i++) {
    const uint8_t digit = base64Value(text[i]);
    if (digit == NOT_A_DIGIT) return false;
    value = (value << 6) | digit;
  }
  into = Address(value);
  return true;
}

void Address::write(uint8_t *text) const {
  for (uint8_t i = 0; i < TEXT_LENGTH; i++) {
    text[i] = base64Digit(static_cast<uint8_t>(value_ >> (18 - 6 * i)) & 0x3F);
  }
}

Address::Class Address::classOf() const {
  const uint8_t first = static_cast<uint8_t>(value_ >> 18);
  const uint8_t second = static_cast<uint8_t>(value_ >> 12) & 0x3F;
  if (first < PLUS) return DEVICE;
  if (isSerial()) return SERIAL_LINE;
  if (isBroadcast()) return BROADCAST;
  return first == SLASH && second == SLASH ? MULTICAST : RESERVED;
}

}  // namespace javino
