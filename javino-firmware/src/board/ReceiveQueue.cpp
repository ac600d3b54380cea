#include "ReceiveQueue.h"

namespace javino {

void ReceiveQueue::forgetUpTo(uint8_t number) {
  const uint8_t index = static_cast<uint8_t>(number - firstNumber_);
  if (index >= count_) return;
  const uint8_t forgotten = static_cast<uint8_t>(index + 1);
  first_ = static_cast<uint8_t>((first_ + forgotten) % config::RECEIVE_QUEUE);
  count_ = static_cast<uint8_t>(count_ - forgotten);
  firstNumber_ = static_cast<uint8_t>(firstNumber_ + forgotten);
}

}  // namespace javino
