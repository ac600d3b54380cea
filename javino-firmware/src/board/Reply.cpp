#include "Reply.h"

#include <string.h>

#include "../framing/Crc16.h"
#include "../framing/Frame.h"

namespace javino {

const uint8_t Reply::STATUS_AT;
const uint16_t Reply::BODY_END;

void Reply::begin(uint8_t sequence) {
  bytes_[0] = sequence;
  setStatus(Status::OK);
  length_ = STATUS_AT + 1;
}

void Reply::setStatus(Status status) {
  bytes_[STATUS_AT] = static_cast<uint8_t>(status);
  if (status != Status::OK) length_ = STATUS_AT + 1;
}

bool Reply::add(const uint8_t *bytes, uint16_t length) {
  if (length > room()) return false;
  memcpy(bytes_ + length_, bytes, length);
  length_ = static_cast<uint16_t>(length_ + length);
  return true;
}

void Reply::finish() {
  Frame::writeHeader(bytes_ + 1, Address::serialLine(), Address::serialLine(),
                     static_cast<uint16_t>(length_ - STATUS_AT));
  Crc16 crc;
  crc.add(bytes_, length_);
  bytes_[length_++] = static_cast<uint8_t>(crc.value());
  bytes_[length_++] = static_cast<uint8_t>(crc.value() >> 8);
}

}  // namespace javino
