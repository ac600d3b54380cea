#include "Request.h"

#include "../framing/Frame.h"

namespace javinolib {

const char Request::HELLO;
const char Request::POLL;
const char Request::STATISTICS;
const uint8_t Request::POLL_LENGTH;

static bool isSerialLine(const uint8_t *address) {
  for (uint8_t i = 0; i != Address::TEXT_LENGTH; i++) {
    if (address[i] != '+') return false;
  }
  return true;
}

bool Request::parse(const uint8_t *bytes, Length length, Request &into) {
  if (length < HEADER_LENGTH) return false;
  uint16_t bits = 0;
  for (uint8_t i = 0; i != HEADER_LENGTH; i++) {
    const uint8_t value = base64Value(bytes[i]);
    if (value == NOT_A_DIGIT) return false;
    bits = static_cast<uint16_t>((bits & 0x3F) << 6 | value);
  }
  into.frame = bytes;
  into.length = static_cast<Length>(length - HEADER_LENGTH);
  into.toBoard = isSerialLine(bytes);
  into.fromHost = isSerialLine(bytes + Address::TEXT_LENGTH);
  return bits == into.length * 8;
}

}  // namespace javinolib
