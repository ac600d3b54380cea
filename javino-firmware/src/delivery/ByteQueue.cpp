#include "ByteQueue.h"

#include <string.h>

namespace javinolib {

const uint8_t ByteQueue::MAX_RECORDS;
const uint8_t ByteQueue::HEAD_LENGTH;

uint8_t *ByteQueue::append(uint16_t length) {
  uint8_t *head = block_ + used_;
  head[0] = static_cast<uint8_t>(length >> 8);
  head[1] = static_cast<uint8_t>(length);
  used_ = static_cast<uint16_t>(used_ + HEAD_LENGTH + length);
  count_++;
  return head + HEAD_LENGTH;
}

void ByteQueue::remove(uint8_t *bytes) {
  const uint16_t at = static_cast<uint16_t>(bytes - block_ - HEAD_LENGTH);
  const uint16_t taken = static_cast<uint16_t>(HEAD_LENGTH + recordAt(at).length);
  used_ = static_cast<uint16_t>(used_ - taken);
  memmove(block_ + at, block_ + at + taken, used_ - at);
  count_--;
}

ByteQueue::Record ByteQueue::recordAt(uint16_t at) const {
  Record record = {nullptr, 0};
  if (at == used_) return record;
  record.bytes = block_ + at + HEAD_LENGTH;
  record.length = static_cast<uint16_t>(block_[at] << 8 | block_[at + 1]);
  return record;
}

}  // namespace javinolib
