#include "BigEndian.h"

namespace javinolib {

void writeUint24(uint8_t *into, uint32_t value) {
  into[0] = static_cast<uint8_t>(value >> 16);
  into[1] = static_cast<uint8_t>(value >> 8);
  into[2] = static_cast<uint8_t>(value);
}

void writeUint32(uint8_t *into, uint32_t value) {
  into[0] = static_cast<uint8_t>(value >> 24);
  writeUint24(into + 1, value);
}

uint32_t readUint24(const uint8_t *from) {
  return static_cast<uint32_t>(from[0]) << 16 | static_cast<uint16_t>(from[1] << 8) | from[2];
}

}  // namespace javinolib
