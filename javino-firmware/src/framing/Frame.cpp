#include "Frame.h"

#include "Address.h"

namespace javinolib {

static const uint8_t ORIGIN_AT = 4;
static const uint8_t SIZE_AT = 8;

FrameError Frame::parse(const uint8_t *bytes, uint16_t length, Frame &into) {
  if (length < HEADER_LENGTH) return FrameError::TOO_SHORT;
  const FrameError error = parseHeader(bytes, into);
  if (error != FrameError::NONE && error != FrameError::BAD_ORIGIN) return error;
  return into.length == length - HEADER_LENGTH ? error : FrameError::SIZE_MISMATCH;
}

FrameError Frame::parseHeader(const uint8_t *bytes, Frame &into) {
  const uint8_t high = base64Value(bytes[SIZE_AT]);
  const uint8_t low = base64Value(bytes[SIZE_AT + 1]);
  if (!Address::parse(bytes, into.destination) || !Address::parse(bytes + ORIGIN_AT, into.origin) ||
      high == NOT_A_DIGIT || low == NOT_A_DIGIT) {
    return FrameError::BAD_DIGIT;
  }
  const uint16_t bits = static_cast<uint16_t>(high << 6 | low);
  if (bits % 8 != 0) return FrameError::PARTIAL_BYTE;
  into.message = bytes + HEADER_LENGTH;
  into.length = bits / 8;
  return into.origin.isDevice() || into.origin.isSerial() ? FrameError::NONE : FrameError::BAD_ORIGIN;
}

void Frame::writeHeader(uint8_t *into, const Address &destination, const Address &origin, uint16_t messageLength) {
  destination.write(into);
  origin.write(into + ORIGIN_AT);
  writeSize(into + SIZE_AT, messageLength);
}

void Frame::writeSize(uint8_t *into, uint16_t messageLength) {
  const uint16_t bits = static_cast<uint16_t>(messageLength * 8);
  into[0] = base64Digit(static_cast<uint8_t>(bits >> 6));
  into[1] = base64Digit(bits & 0x3F);
}

}  // namespace javinolib
