#include "Crc16.h"

namespace javino {

// For each byte eight steps of the reflected polynomial 0x8408 (0x1021 mirrored) at once, without a table:
// a table would cost 512 bytes of flash, the loop over bits four times the cycles.
void Crc16::add(const uint8_t *bytes, size_t length) {
  uint16_t remainder = remainder_;
  for (const uint8_t *const end = bytes + length; bytes != end; bytes++) {
    uint8_t folded = static_cast<uint8_t>(*bytes ^ remainder);
    folded = static_cast<uint8_t>(folded ^ (folded << 4));
    const uint16_t wide = folded;
    remainder = static_cast<uint16_t>((remainder >> 8) ^ (wide << 8) ^ (wide << 3) ^ (wide >> 4));
  }
  remainder_ = remainder;
}

}  // namespace javino
