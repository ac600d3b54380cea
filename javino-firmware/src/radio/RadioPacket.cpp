#include "RadioPacket.h"

#include "../support/Crc16.h"

namespace javino {

namespace {

// The CRC of anything with its own CRC behind it, low byte first (the complement of X-25's residue 0xF0B8).
const uint16_t CRC_OF_INTACT_PACKET = 0x0F47;

bool differInOneBit(uint8_t a, uint8_t b) {
  const uint8_t difference = a ^ b;
  return difference != 0 && (difference & (difference - 1)) == 0;
}

}  // namespace

bool RadioPacket::isIntact() const {
  Crc16 crc;
  crc.add(bytes, bytes[0]);
  return crc.value() == CRC_OF_INTACT_PACKET;
}

bool RadioPacket::mend() {
  uint8_t right = NO_NIBBLE;
  for (uint8_t nibble = 0; nibble < 16; nibble++) {
    if (!differInOneBit(linecode::symbolOf(nibble), wrongSymbol)) continue;
    setWrongNibble(nibble);
    if (!isIntact()) continue;
    if (right != NO_NIBBLE) return false;
    right = nibble;
  }
  if (right == NO_NIBBLE) return false;
  setWrongNibble(right);
  return true;
}

void RadioPacket::setWrongNibble(uint8_t nibble) {
  uint8_t &byte = bytes[wrongNibble / 2];
  const bool high = wrongNibble % 2 == 0;
  byte = static_cast<uint8_t>(high ? (byte & 0x0F) | nibble << 4 : (byte & 0xF0) | nibble);
}

}  // namespace javino
