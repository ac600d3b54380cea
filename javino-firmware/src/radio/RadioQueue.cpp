#include "RadioQueue.h"

namespace javinolib {

namespace {

// Keeps the compiler from moving a packet's bytes across the mark that hands them over.
inline void keepOrder() { __asm__ __volatile__("" ::: "memory"); }

}  // namespace

RadioQueue::RadioQueue() : write_(slots_), read_(slots_) {}

RadioPacket *RadioQueue::claim() { return write_->full ? nullptr : &write_->packet; }

void RadioQueue::commit() {
  keepOrder();
  write_->full = true;
  write_ = following(write_);
}

RadioPacket *RadioQueue::oldest() {
  if (!read_->full) return nullptr;
  keepOrder();
  return &read_->packet;
}

void RadioQueue::release() {
  keepOrder();
  read_->full = false;
  read_ = following(read_);
}

}  // namespace javinolib
