#include "BitClock.h"

namespace javinolib {

BitClock::BitClock(uint16_t bitTicks) : bitTicks_(bitTicks) {}

void BitClock::reset(bool level) {
  phase_ = 0;
  balance_ = 0;
  steadyLevel_ = level;
}

bool BitClock::advance(uint16_t &ticks, bool level, bool &bit) {
  if (level != steadyLevel_ && ticks >= bitTicks_ / 4) {
    steadyLevel_ = level;
    steer();
  }
  const uint16_t left = bitTicks_ - phase_;
  const bool ends = ticks >= left;
  const uint16_t taken = ends ? left : ticks;
  ticks -= taken;
  phase_ += taken;
  balance_ += level ? static_cast<int16_t>(taken) : -static_cast<int16_t>(taken);
  if (ends) {
    bit = balance_ > 0;
    phase_ = 0;
    balance_ = 0;
  }
  return ends;
}

// The line has changed. In the first half of a window that is late, and the border waits; in the second half it is
// early, and the border moves up.
void BitClock::steer() {
  const bool late = phase_ < bitTicks_ / 2;
  const uint16_t error = late ? phase_ : bitTicks_ - phase_;
  const uint16_t move = error < bitTicks_ / 4 ? error / 2 : bitTicks_ / 8;
  if (late) {
    phase_ -= move;
  } else {
    phase_ += move;
  }
}

}  // namespace javinolib
