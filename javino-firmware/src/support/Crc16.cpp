#include "Crc16.h"

#ifdef __AVR__
#include <util/crc16.h>
#endif

namespace javinolib {

namespace {

// Eight steps of the reflected polynomial 0x8408 (0x1021 mirrored) at once, without a table of 512 bytes of flash.
uint16_t step(uint16_t remainder, uint8_t byte) {
#ifdef __AVR__
  return _crc_ccitt_update(remainder, byte);  // assembly: half the cycles of what follows
#else
  uint8_t folded = static_cast<uint8_t>(byte ^ remainder);
  folded = static_cast<uint8_t>(folded ^ (folded << 4));
  const uint16_t wide = folded;
  return static_cast<uint16_t>((remainder >> 8) ^ (wide << 8) ^ (wide << 3) ^ (wide >> 4));
#endif
}

}  // namespace

uint16_t Crc16::extend(uint16_t value, const uint8_t *bytes, size_t length) {
  uint16_t remainder = static_cast<uint16_t>(~value);
  for (const uint8_t *const end = bytes + length; bytes != end; bytes++) remainder = step(remainder, *bytes);
  return static_cast<uint16_t>(~remainder);
}

uint16_t Crc16::changeOf(uint8_t bits, uint8_t following) {
  uint16_t change = step(0, bits);
  for (; following != 0; following--) change = step(change, 0);
  return change;
}

}  // namespace javinolib
