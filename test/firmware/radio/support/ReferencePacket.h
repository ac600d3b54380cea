#pragma once

#include <cstdint>
#include <vector>

typedef std::vector<uint8_t> Bytes;
typedef std::vector<bool> Bits;

// Radio packets made from SPEC 6 alone, without a line of the code under test.
namespace reference {

uint16_t crc(const Bytes &bytes);

// Training, start symbol, then these bytes as they are.
Bits lineBits(const Bytes &bytes);

// Count, payload, CRC.
Bytes packetOf(const Bytes &payload);

inline Bits packetBits(const Bytes &payload) { return lineBits(packetOf(payload)); }

}  // namespace reference
