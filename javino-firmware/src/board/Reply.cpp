#include "Reply.h"

#include <string.h>

#include "../framing/Frame.h"

namespace javinolib {

const uint8_t Reply::STATUS_AT;

void Reply::setStatus(Status status) {
  bytes_[STATUS_AT] = static_cast<uint8_t>(status);
  if (status != Status::OK) begin();
}

bool Reply::add(const uint8_t *bytes, Length length) {
  if (length > room()) return false;
  memcpy(bytes_ + length_, bytes, length);
  length_ = static_cast<Length>(length_ + length);
  return true;
}

void Reply::finish() {
  memcpy(kept_, bytes_ + STATUS_AT, sizeof kept_);
  for (uint8_t at = 1; at <= 2 * Address::TEXT_LENGTH; at++) bytes_[at] = '+';
  Frame::writeSize(bytes_ + 1 + 2 * Address::TEXT_LENGTH, static_cast<Length>(length_ - STATUS_AT));
}

bool Reply::recall() {
  if (length_ > STATUS_AT + sizeof kept_) return false;
  memcpy(bytes_ + STATUS_AT, kept_, sizeof kept_);
  finish();
  return true;
}

const uint8_t Record::HEAD_LENGTH;

Record::Record(Reply &reply, char type)
    : reply_(reply), at_(reply.bytes_ + reply.length_), end_(reply.bytes_ + reply.bodyEnd_) {
  *at_ = static_cast<uint8_t>(type);  // where nothing fits the CRC comes later
  add(at_, HEAD_LENGTH);
}

// Both loops keep the place in a register: a reading may have some 500 bytes, and the host waits for it.

void Record::add(const uint8_t *bytes, Length length) {
  uint8_t *at = at_;
  if (at == nullptr) return;
  if (length > static_cast<uint16_t>(end_ - at)) {
    at = nullptr;
  } else {
    for (; length != 0; length--) *at++ = *bytes++;
  }
  at_ = at;
}

void Record::add(const FlashText *text) {
  uint8_t *at = at_;
  if (at == nullptr) return;
  const uint8_t *from = reinterpret_cast<const uint8_t *>(text);
  for (uint8_t next; (next = flashByte(from++)) != 0; *at++ = next) {
    if (at == end_) {
      at = nullptr;
      break;
    }
  }
  at_ = at;
}

bool Record::close() {
  if (at_ == nullptr) return false;
  Reply &reply = reply_;
  uint8_t *const start = reply.bytes_ + reply.length_;
  const Length length = static_cast<Length>(at_ - start);
  reply.length_ = static_cast<Length>(reply.length_ + length);
  const Length valueLength = static_cast<Length>(length - HEAD_LENGTH);
  start[1] = static_cast<uint8_t>(valueLength >> 8);
  start[2] = static_cast<uint8_t>(valueLength);
  return true;
}

}  // namespace javinolib
