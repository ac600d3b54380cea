#include "RadioQueue.h"

namespace javino {

namespace {

uint8_t following(uint8_t index) { return index + 1 == RadioQueue::CAPACITY ? 0 : static_cast<uint8_t>(index + 1); }

// Keeps the compiler from moving a packet's bytes across the mark that hands them over.
inline void keepOrder() { __asm__ __volatile__("" ::: "memory"); }

}  // namespace

RadioQueue::RadioQueue() : writeIndex_(0), readIndex_(0) {
  for (uint8_t i = 0; i < CAPACITY; i++) slots_[i].full = false;
}

RadioPacket *RadioQueue::claim() {
  Slot &slot = slots_[writeIndex_];
  return slot.full ? nullptr : &slot.packet;
}

void RadioQueue::commit() {
  keepOrder();
  slots_[writeIndex_].full = true;
  writeIndex_ = following(writeIndex_);
}

RadioPacket *RadioQueue::oldest() {
  Slot &slot = slots_[readIndex_];
  if (!slot.full) return nullptr;
  keepOrder();
  return &slot.packet;
}

void RadioQueue::release() {
  keepOrder();
  slots_[readIndex_].full = false;
  readIndex_ = following(readIndex_);
}

}  // namespace javino
