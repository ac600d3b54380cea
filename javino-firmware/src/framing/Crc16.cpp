#include "Crc16.h"

namespace javino {

// Eight steps of the reflected polynomial 0x8408 (0x1021 mirrored) at once, without a table:
// a table would cost 512 bytes of flash, the loop over bits four times the cycles.
void Crc16::add(uint8_t byte) {
  uint8_t folded = static_cast<uint8_t>(byte ^ remainder_);
  folded = static_cast<uint8_t>(folded ^ (folded << 4));
  const uint16_t wide = folded;
  remainder_ = static_cast<uint16_t>((remainder_ >> 8) ^ (wide << 8) ^ (wide << 3) ^ (wide >> 4));
}

void Crc16::add(const uint8_t *bytes, size_t length) {
  for (size_t i = 0; i < length; i++) add(bytes[i]);
}

}  // namespace javino
