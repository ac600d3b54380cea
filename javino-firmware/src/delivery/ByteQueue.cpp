#include "ByteQueue.h"

#include <string.h>

namespace javinolib {

const uint8_t ByteQueue::MAX_RECORDS;
const uint8_t ByteQueue::HEAD_LENGTH;
const uint8_t ByteQueue::LEAST_LEFT;

uint8_t *ByteQueue::append(Length length) {
  uint8_t *head = block_ + used_;
  head[0] = static_cast<uint8_t>(length >> 8);
  head[1] = static_cast<uint8_t>(length);
  used_ = static_cast<Length>(used_ + HEAD_LENGTH + length);
  count_++;
  return head + HEAD_LENGTH;
}

uint8_t *ByteQueue::lend(Length length) {
  if (used_ + LEAST_LEFT + length > size_) return nullptr;
  size_ = static_cast<Length>(size_ - length);
  return block_ + size_;
}

void ByteQueue::remove(uint8_t *bytes) {
  uint8_t *const head = bytes - HEAD_LENGTH;
  const Length length = static_cast<Length>(HEAD_LENGTH + recordAt(head).length);
  used_ = static_cast<Length>(used_ - length);
  count_--;
  memmove(head, head + length, static_cast<Length>(block_ + used_ - head));
}

ByteQueue::Record ByteQueue::recordAt(uint8_t *head) const {
  Record record = {nullptr, 0};
  if (head == block_ + used_) return record;
  record.bytes = head + HEAD_LENGTH;
  record.length = static_cast<Length>(head[0] << 8 | head[1]);
  return record;
}

}  // namespace javinolib
