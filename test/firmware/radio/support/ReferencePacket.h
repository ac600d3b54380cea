#pragma once

#include <cstdint>
#include <random>
#include <vector>

typedef std::vector<uint8_t> Bytes;
typedef std::vector<bool> Bits;

inline Bytes randomBytes(size_t length, std::mt19937 &random) {
  Bytes bytes(length);
  for (uint8_t &byte : bytes) byte = static_cast<uint8_t>(random());
  return bytes;
}

// Radio packets made from SPEC 6 alone, without a line of the code under test.
namespace reference {

uint16_t crc(const Bytes &bytes);

// Training, start symbol, then these bytes as they are.
Bits lineBits(const Bytes &bytes);

// Count, payload, CRC.
Bytes packetOf(const Bytes &payload);

inline Bits packetBits(const Bytes &payload) { return lineBits(packetOf(payload)); }

}  // namespace reference
