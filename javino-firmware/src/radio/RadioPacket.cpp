#include "RadioPacket.h"

#include "../support/Crc16.h"

namespace javinolib {

const uint8_t RadioPacket::NO_COUNT;
const uint16_t RadioPacket::CRC_OF_INTACT;
const uint8_t RadioPacket::NO_PATH;

namespace {

const uint8_t SYMBOL_MASK = 0x3F;

}  // namespace

uint8_t RadioPacket::symbol(uint8_t index) const {
  if (areBytes) return linecode::symbolOf(linecode::nibbleIn(room, index));
  // Four symbols lie in three bytes.
  const uint8_t *at = room + index / 4 * 3;
  switch (index % 4) {
    case 0: return at[0] & SYMBOL_MASK;
    case 1: return static_cast<uint8_t>((at[0] >> 6 | at[1] << 2) & SYMBOL_MASK);
    case 2: return static_cast<uint8_t>((at[1] >> 4 | at[2] << 4) & SYMBOL_MASK);
    default: return static_cast<uint8_t>(at[2] >> 2);
  }
}

uint16_t RadioPacket::byte(uint8_t index) const {
  const uint8_t high = linecode::nibbleOf(symbol(static_cast<uint8_t>(2 * index)));
  const uint8_t low = linecode::nibbleOf(symbol(static_cast<uint8_t>(2 * index + 1)));
  const uint8_t byte = static_cast<uint8_t>(high << 4 | (low & 0x0F));
  return high == linecode::NO_NIBBLE || low == linecode::NO_NIBBLE ? NO_BYTE | byte : byte;
}

uint8_t RadioPacket::count() const {
  const uint16_t count = byte(0);
  return count >= linecode::MIN_COUNT && count <= linecode::MAX_COUNT ? static_cast<uint8_t>(count) : NO_COUNT;
}

uint16_t RadioPacket::path() const {
  const uint8_t bytes = count();
  if (bytes == NO_COUNT || 2 * bytes > symbols) return NO_PATH;
  Crc16 crc;
  for (uint8_t i = 0; i < bytes; i++) {
    const uint16_t next = byte(i);
    if (next >= NO_BYTE) return NO_PATH;
    const uint8_t known = static_cast<uint8_t>(next);
    crc.add(&known, 1);
  }
  return pathOf(crc.value());
}

// Three bytes of symbols make two bytes: none is overwritten before it was read.
void RadioPacket::makeBytes(uint8_t length) {
  for (uint8_t i = 0; i < length; i++) room[i] = readByte(i);
  areBytes = true;
}

uint16_t RadioPacket::pathOfBytes() const {
  Crc16 crc;
  crc.add(room, room[0]);
  return pathOf(crc.value());
}

uint16_t RadioPacket::wrongBits(uint8_t first, const uint8_t *bytes, uint8_t length) const {
  if (first + 2 * length > symbols) return UINT16_MAX;
  uint16_t wrong = 0;
  for (uint8_t i = 0; i < 2 * length; i++) {
    const uint8_t right = linecode::symbolOf(linecode::nibbleIn(bytes, i));
    wrong = static_cast<uint16_t>(wrong + linecode::onesOf(symbol(static_cast<uint8_t>(first + i)) ^ right));
  }
  return wrong;
}

}  // namespace javinolib
