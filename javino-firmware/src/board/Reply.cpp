#include "Reply.h"

#include <string.h>

#include "../support/Crc16.h"
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

const uint8_t Record::HEAD_LENGTH;

Record::Record(Reply &reply, char type) : reply_(reply), start_(reply.mark()) {
  const uint8_t head[HEAD_LENGTH] = {static_cast<uint8_t>(type), 0, 0};
  fits_ = reply_.add(head, HEAD_LENGTH);
}

void Record::add(uint8_t byte) { add(&byte, 1); }

void Record::add(const uint8_t *bytes, uint16_t length) { fits_ = fits_ && reply_.add(bytes, length); }

bool Record::close() {
  if (!fits_) {
    reply_.truncate(start_);
    return false;
  }
  const uint16_t length = static_cast<uint16_t>(reply_.mark() - start_ - HEAD_LENGTH);
  reply_.replace(static_cast<uint16_t>(start_ + 1), static_cast<uint8_t>(length >> 8));
  reply_.replace(static_cast<uint16_t>(start_ + 2), static_cast<uint8_t>(length));
  return true;
}

}  // namespace javino
