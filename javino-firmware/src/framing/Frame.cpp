#include "Frame.h"

#include "Address.h"

namespace javinolib {

static const uint8_t ORIGIN_AT = 4;
static const uint8_t SIZE_AT = 8;

FrameError Frame::parse(const uint8_t *bytes, Length length, Frame &into) {
  if (length < HEADER_LENGTH) return FrameError::TOO_SHORT;
  const FrameError error = parseHeader(bytes, into);
  if (error != FrameError::NONE && error != FrameError::BAD_ORIGIN) return error;
  return into.length == length - HEADER_LENGTH ? error : FrameError::SIZE_MISMATCH;
}

FrameError Frame::parseHeader(const uint8_t *bytes, Frame &into) {
  if (!Address::parse(bytes, into.destination) || !Address::parse(bytes + ORIGIN_AT, into.origin)) {
    return FrameError::BAD_DIGIT;
  }
  const uint8_t high = base64Value(bytes[SIZE_AT]);
  const uint8_t low = base64Value(bytes[SIZE_AT + 1]);
  if (high == NOT_A_DIGIT || low == NOT_A_DIGIT) return FrameError::BAD_DIGIT;
  if (low % 8 != 0) return FrameError::PARTIAL_BYTE;
  into.message = bytes + HEADER_LENGTH;
  const uint16_t size = static_cast<uint16_t>(high * 8 + low / 8);
  into.length = static_cast<Length>(size);
  if (into.length != size) return FrameError::SIZE_MISMATCH;  // on a small board
  return into.origin.isDevice() || into.origin.isSerial() ? FrameError::NONE : FrameError::BAD_ORIGIN;
}

void Frame::writeHeader(uint8_t *into, const Address &destination, const Address &origin, Length messageLength) {
  destination.write(into);
  origin.write(into + ORIGIN_AT);
  writeSize(into + SIZE_AT, messageLength);
}

// Two digits of six bits: the size in bits.
void Frame::writeSize(uint8_t *into, Length messageLength) {
  into[0] = base64Digit(static_cast<uint8_t>(messageLength / 8));
  into[1] = base64Digit(messageLength % 8 * 8);
}

}  // namespace javinolib
