#include "Fragments.h"

#include <string.h>

namespace javinolib {
namespace fragments {

uint8_t count(Length frameLength, uint8_t longest) {
  if (frameLength <= static_cast<Length>(HEADER_LENGTH + longest)) return 1;
  return static_cast<uint8_t>((frameLength + longest - 1u) / longest);
}

uint8_t length(Length frameLength, uint8_t index, uint8_t longest) {
  const uint16_t left = static_cast<Length>(frameLength - index * longest);
  return static_cast<uint8_t>(left < longest ? left : longest);
}

uint8_t bitOf(uint8_t index) {
  uint8_t bit = 1;
  for (; index != 0; index--) bit = static_cast<uint8_t>(bit << 1);
  return bit;
}

uint8_t all(uint8_t count) { return static_cast<uint8_t>(2 * bitOf(static_cast<uint8_t>(count - 1)) - 1); }

uint8_t cut(const uint8_t *frame, Length frameLength, uint8_t id, uint8_t index, uint8_t longest, uint8_t *into) {
  const uint8_t at = index & (MAX_FRAGMENTS - 1);
  const uint8_t bytes = length(frameLength, at, longest);
  memcpy(into, frame, HEADER_LENGTH);
  Address::fragment(id, index).write(into);
  Frame::writeSize(into + 2 * Address::TEXT_LENGTH, bytes);
  memcpy(into + HEADER_LENGTH, frame + at * longest, bytes);
  return static_cast<uint8_t>(HEADER_LENGTH + bytes);
}

}  // namespace fragments
}  // namespace javinolib
