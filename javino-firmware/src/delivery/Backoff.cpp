#include "Backoff.h"

#include "../Config.h"
#include "MediumAccess.h"

namespace javinolib {

static const uint8_t LONG_QUIET = 15;
static const uint8_t FIRST_SLOTS = 6;
static const uint8_t LEAST_WINDOW = 16;
static const uint8_t MOST_WINDOW = 255;
static const uint8_t LAST_DOUBLING = 3;  // who retries waits longer, as boards out of range may be in its way

// Idle slots beyond the first ones. If half of all beginnings come after fewer, one slot in five is taken.
static const uint8_t FEW_IDLE_SLOTS = 3;
static const uint16_t PARTS = 256;  // of a slot, that the window is counted in
static const uint8_t SHARE = 8;     // the window changes by this part of it

// Slots after which a sender is a hidden one: an answer to a packet that is heard comes after fewer.
static const uint8_t UNHEARD_SLOTS = 24;
static const uint8_t KNOWN = 0xFF;  // a bit for each unicast until it is forgotten
static const uint8_t TURN_MASK = 7;
static const uint8_t YIELDED_SLOTS = 80;
static const uint8_t YIELDED_MASK = 15;

Backoff::Backoff() : window_(LEAST_WINDOW * PARTS) {}

// Notes that somebody has begun when the air is quiet again.
void Backoff::listen(uint8_t quietSlots) {
  if (quietSlots == 0 || (quietSlots & MediumAccess::CIRCLE) != 0) return;
  const bool begun = quietSlots < quiet_;
  const uint8_t before = quiet_;
  quiet_ = quietSlots;
  if (!begun || before < FIRST_SLOTS) return;  // an acknowledgement waits less: it tells nothing
  const uint16_t change = window_ / SHARE;
  if (before - FIRST_SLOTS < FEW_IDLE_SLOTS) {
    window_ = static_cast<uint16_t>(window_ + change);
    if (window_ < change) window_ = UINT16_MAX;
  } else {
    window_ = static_cast<uint16_t>(window_ - change);
    if (window_ < LEAST_WINDOW * PARTS) window_ = LEAST_WINDOW * PARTS;
  }
}

static uint8_t doubled(uint8_t window) {
  return static_cast<uint8_t>(window > MOST_WINDOW / 2 ? MOST_WINDOW : 2 * window);
}

void Backoff::begin(uint8_t attempt, uint8_t quietSlots, Random &random) {
  counted_ = quietSlots < FIRST_SLOTS ? FIRST_SLOTS : quietSlots;
  uint8_t window = static_cast<uint8_t>(window_ / PARTS);
  uint8_t doublings = attempt < LAST_DOUBLING ? attempt : LAST_DOUBLING;
  if (config::LARGE && hidden_ != 0) doublings = static_cast<uint8_t>(2 * doublings);
  for (; doublings != 0; doublings--) window = doubled(window);
  left_ = static_cast<uint8_t>(random.next(UINT8_MAX) * window >> 8);
  if (attempt != 0) return;
  // Since it was heard of, a unicast of ours has been acknowledged.
  const bool yields = config::LARGE && hidden_ != 0 && hidden_ != KNOWN;
  if (quietSlots >= (yields ? YIELDED_SLOTS : LONG_QUIET)) {
    left_ = 0;
  } else if (yields) {
    left_ = static_cast<uint8_t>((left_ & YIELDED_MASK) + YIELDED_SLOTS - quietSlots);
  }
}

bool Backoff::otherAcknowledged(Random &random) {
  if (quiet_ >= UNHEARD_SLOTS) hidden_ = KNOWN;
  if (hidden_ != 0) left_ = static_cast<uint8_t>(random.next(TURN_MASK));
  return hidden_ != 0;
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
