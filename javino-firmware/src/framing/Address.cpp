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
const uint16_t Address::PIECES;
const uint16_t Address::ACKNOWLEDGEMENTS;
const uint16_t Address::PLUSES;
const uint16_t Address::SLASHES;
const uint16_t Address::FIRST_PLUS;

/// `self`, `true`, `else` and `elif` have a meaning in AgentSpeak: no agent could tell such a sender from it.
static bool isWord(uint16_t group, uint16_t member) {
  switch (group) {
    case 0xB1E: return member == 0x95F;
    case 0xB6B: return member == 0xB9E;
    case 0x7A5: return member == 0xB1E || member == 0x89F;
    default: return false;
  }
}

bool Address::parse(const uint8_t *text, Address &into) {
  uint16_t halves[2] = {0, 0};
  for (uint8_t i = 0; i < TEXT_LENGTH; i++) {
    const uint8_t digit = base64Value(text[i]);
    if (digit == NOT_A_DIGIT) return false;
    uint16_t &half = halves[i / 2];
    half = static_cast<uint16_t>(half << 6 | digit);
  }
  into.group_ = halves[0];
  into.member_ = halves[1];
  return true;
}

Address Address::stored(const uint8_t *bytes) {
  return Address(static_cast<uint16_t>(bytes[0] << 4 | bytes[1] >> 4),
                 static_cast<uint16_t>((bytes[1] & 0x0F) << 8 | bytes[2]));
}

void Address::store(uint8_t *into) const {
  into[0] = static_cast<uint8_t>(group_ >> 4);
  into[1] = static_cast<uint8_t>(group_ << 4 | member_ >> 8);
  into[2] = static_cast<uint8_t>(member_);
}

void Address::write(uint8_t *text) const {
  text[0] = base64Digit(static_cast<uint8_t>(group_ >> 6));
  text[1] = base64Digit(group_ & 0x3F);
  text[2] = base64Digit(static_cast<uint8_t>(member_ >> 6));
  text[3] = base64Digit(member_ & 0x3F);
}

Address::Class Address::classOf() const {
  if (group_ < FIRST_PLUS) return isWord(group_, member_) ? RESERVED : DEVICE;
  if (group_ == SLASHES) return member_ == SLASHES ? BROADCAST : MULTICAST;
  if (group_ == PIECES) return PIECE;
  if (group_ == ACKNOWLEDGEMENTS) return ACKNOWLEDGEMENT;
  return group_ == PLUSES && member_ == PLUSES ? SERIAL_LINE : RESERVED;
}

bool Address::operator==(const Address &other) const { return group_ == other.group_ && member_ == other.member_; }

}  // namespace javinolib
