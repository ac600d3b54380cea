#include "ReferencePacket.h"

namespace reference {

namespace {

const uint8_t SYMBOLS[] = {0x0D, 0x0E, 0x13, 0x15, 0x16, 0x19, 0x1A, 0x1C,
                           0x23, 0x25, 0x26, 0x29, 0x2A, 0x2C, 0x32, 0x34};

void append(Bits &bits, uint8_t symbol) {
  for (int i = 0; i < 6; i++) bits.push_back(symbol >> i & 1);
}

}  // namespace

// The polynomial division of CRC-16/X-25, bit by bit.
uint16_t crc(const Bytes &bytes) {
  uint16_t remainder = 0xFFFF;
  for (uint8_t byte : bytes) {
    for (int i = 0; i < 8; i++) {
      const bool odd = (remainder ^ byte >> i) & 1;
      remainder = static_cast<uint16_t>(remainder >> 1 ^ (odd ? 0x8408 : 0));
    }
  }
  return static_cast<uint16_t>(~remainder);
}

Bits lineBits(const Bytes &bytes) {
  Bits bits;
  for (int i = 0; i < 6; i++) append(bits, 0x2A);
  append(bits, 0x38);
  append(bits, 0x2C);
  for (uint8_t byte : bytes) {
    append(bits, SYMBOLS[byte >> 4]);
    append(bits, SYMBOLS[byte & 15]);
  }
  return bits;
}

Bytes packetOf(const Bytes &payload) {
  Bytes packet(1, static_cast<uint8_t>(payload.size() + 3));
  packet.insert(packet.end(), payload.begin(), payload.end());
  const uint16_t check = crc(packet);
  packet.push_back(static_cast<uint8_t>(check));
  packet.push_back(static_cast<uint8_t>(check >> 8));
  return packet;
}

}  // namespace reference
