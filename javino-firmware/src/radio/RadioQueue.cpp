#include "RadioQueue.h"

#include <string.h>

namespace javino {

namespace {

uint8_t following(uint8_t index) { return index + 1 == RadioQueue::CAPACITY ? 0 : static_cast<uint8_t>(index + 1); }

// Keeps the compiler from moving a payload's bytes across the length that hands them over.
inline void keepOrder() { __asm__ __volatile__("" ::: "memory"); }

}  // namespace

RadioQueue::RadioQueue() : writeIndex_(0), readIndex_(0) {
  for (uint8_t i = 0; i < CAPACITY; i++) slots_[i].length = 0;
}

uint8_t *RadioQueue::claim() {
  Slot &slot = slots_[writeIndex_];
  return slot.length == 0 ? slot.payload : nullptr;
}

void RadioQueue::commit(uint8_t length) {
  keepOrder();
  slots_[writeIndex_].length = length;
  writeIndex_ = following(writeIndex_);
}

uint8_t RadioQueue::take(uint8_t *payload) {
  const uint8_t length = slots_[readIndex_].length;
  if (length == 0) return 0;
  keepOrder();
  memcpy(payload, slots_[readIndex_].payload, length);
  release();
  return length;
}

void RadioQueue::clear() {
  while (!empty()) release();
}

void RadioQueue::release() {
  keepOrder();
  slots_[readIndex_].length = 0;
  readIndex_ = following(readIndex_);
}

}  // namespace javino
