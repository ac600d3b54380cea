#include "Backoff.h"

#include "MediumAccess.h"

namespace javinolib {

static const uint8_t LONG_QUIET = 15;
static const uint8_t FIRST_SLOTS = 6;
static const uint16_t LEAST_WINDOW = 16;
static const uint16_t MOST_WINDOW = 256;
static const uint8_t LAST_DOUBLING = 3;  // who retries waits longer, as boards out of range may be in its way

// Of the slots beyond the first ones. Where half of all beginnings come after fewer, one slot in five is taken.
static const uint8_t FEW_IDLE_SLOTS = 3;
static const uint8_t PARTS = 16;  // of a slot, that the window is counted in
static const uint8_t SHARE = 8;   // the window changes by this part of it

Backoff::Backoff() : window_(LEAST_WINDOW * PARTS) {}

void Backoff::listen(uint8_t quietSlots) {
  if ((quietSlots & MediumAccess::CIRCLE) != 0) return;
  const bool begun = quietSlots < quiet_;
  const uint8_t before = quiet_;
  quiet_ = quietSlots;
  if (!begun || before < FIRST_SLOTS) return;  // an acknowledgement waits less: it tells nothing
  const uint16_t change = window_ / SHARE;
  if (before - FIRST_SLOTS < FEW_IDLE_SLOTS) {
    window_ = static_cast<uint16_t>(window_ + change);
    if (window_ > MOST_WINDOW * PARTS) window_ = MOST_WINDOW * PARTS;
  } else {
    window_ = static_cast<uint16_t>(window_ - change);
    if (window_ < LEAST_WINDOW * PARTS) window_ = LEAST_WINDOW * PARTS;
  }
}

void Backoff::begin(uint8_t attempt, uint8_t quietSlots, Random &random) {
  const uint8_t doublings = attempt < LAST_DOUBLING ? attempt : LAST_DOUBLING;
  const bool atOnce = attempt == 0 && quietSlots >= LONG_QUIET;
  counted_ = quietSlots < FIRST_SLOTS ? FIRST_SLOTS : quietSlots;
  uint16_t window = static_cast<uint16_t>(window_ / PARTS << doublings);
  if (window > MOST_WINDOW) window = MOST_WINDOW;
  left_ = atOnce ? 0 : static_cast<uint8_t>(static_cast<uint32_t>(random.next(UINT16_MAX)) * window >> 16);
}

bool Backoff::isOver(uint8_t quietSlots) {
  if (quietSlots < FIRST_SLOTS) {
    counted_ = FIRST_SLOTS;
    return false;
  }
  for (; counted_ != quietSlots && left_ != 0; counted_ = MediumAccess::slotAfter(counted_)) left_--;
  return left_ == 0;
}

}  // namespace javinolib
