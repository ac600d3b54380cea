#include "Address.h"

namespace javinolib {

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

const uint8_t Address::TEXT_LENGTH;
const uint8_t Address::STORED_LENGTH;
const uint8_t Address::FIRST_PLUS;
const uint16_t Address::FRAGMENTS;
const uint16_t Address::ACKNOWLEDGEMENTS;
const uint16_t Address::PLUSES;
const uint16_t Address::SLASHES;

// `self`, `true`, `else` and `elif` have a meaning in AgentSpeak: no agent could tell such a sender from it.
static bool isWord(Uint24 value) {
  return value == 0xB1E95F || value == 0xB6BB9E || value == 0x7A5B1E || value == 0x7A589F;
}

bool Address::parse(const uint8_t *text, Address &into) {
  Uint24 value = 0;
  for (uint8_t i = 0; i < TEXT_LENGTH; i++) {
    const uint8_t digit = base64Value(text[i]);
    if (digit == NOT_A_DIGIT) return false;
    value = value << 6 | digit;
  }
  writeUint24(into.bytes_, value);
  return true;
}

void Address::write(uint8_t *text) const {
  Uint24 rest = this->value();
  for (uint8_t *digit = text + TEXT_LENGTH; digit != text; rest >>= 6) *--digit = base64Digit(rest & 0x3F);
}

Address::Kind Address::kind() const {
  const Uint24 value = this->value();
  if (bytes_[0] < FIRST_PLUS) return isWord(value) ? RESERVED : DEVICE;
  switch (static_cast<uint16_t>(value >> 8) & 0xFFF0) {
    case SLASHES << 4: return value == 0xFFFFFF ? BROADCAST : MULTICAST;
    case FRAGMENTS << 4: return FRAGMENT;
    case ACKNOWLEDGEMENTS << 4: return ACKNOWLEDGEMENT;
    default: return value == 0xFBEFBE ? SERIAL_LINE : RESERVED;
  }
}

bool Address::operator==(const Address &other) const { return memcmp(bytes_, other.bytes_, sizeof bytes_) == 0; }

}  // namespace javinolib
