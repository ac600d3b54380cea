#include "BigEndian.h"

#include <string.h>

namespace javinolib {

void writeUint24(uint8_t *into, Uint24 value) {
  into[0] = static_cast<uint8_t>(value >> 16);
  into[1] = static_cast<uint8_t>(value >> 8);
  into[2] = static_cast<uint8_t>(value);
}

void writeUint32(uint8_t *into, uint32_t value) {
  into[0] = static_cast<uint8_t>(value >> 24);
  writeUint24(into + 1, static_cast<Uint24>(value));
}

// Not shifted together: a quarter of the code, on all chips of Arduino, which have the least significant byte first.
uint32_t readUint24(const uint8_t *from) {
  const uint8_t bytes[] = {from[2], from[1], from[0], 0};
  uint32_t value;
  memcpy(&value, bytes, sizeof value);
  return value;
}

}  // namespace javinolib
