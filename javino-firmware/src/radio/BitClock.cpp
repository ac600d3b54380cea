#include "BitClock.h"

namespace javino {

BitClock::BitClock(uint16_t bitTicks)
    : bitTicks_(bitTicks), settleTicks_(bitTicks / 4), maxSteerTicks_(bitTicks / 8) {
  reset(false);
}

void BitClock::reset(bool level) {
  phase_ = 0;
  balance_ = 0;
  level_ = level;
  steadyLevel_ = level;
  runTicks_ = 0;
  edgePhase_ = 0;
}

bool BitClock::advance(uint16_t &ticks, bool level, bool &bit) {
  if (level != level_) {
    level_ = level;
    runTicks_ = 0;
    edgePhase_ = phase_;
  }
  while (ticks != 0) {
    const uint16_t taken = step(ticks);
    ticks -= taken;
    phase_ += taken;
    balance_ += level ? static_cast<int16_t>(taken) : -static_cast<int16_t>(taken);
    if (level_ != steadyLevel_) {
      runTicks_ += taken;
      if (runTicks_ >= settleTicks_) steer();
    }
    if (phase_ >= bitTicks_) {
      phase_ -= bitTicks_;
      bit = balance_ > 0;
      balance_ = 0;
      return true;
    }
  }
  return false;
}

// Stops at the end of the window, and where a new level has lasted long enough to be believed.
uint16_t BitClock::step(uint16_t ticks) const {
  uint16_t most = bitTicks_ - phase_;
  if (level_ != steadyLevel_ && settleTicks_ - runTicks_ < most) most = settleTicks_ - runTicks_;
  return ticks < most ? ticks : most;
}

// A change in the first half of a window came late: the border waits. In the second half it came early: the border
// moves up. The first half of the window never ends within the quarter bit since, so phase_ stays above the step.
void BitClock::steer() {
  steadyLevel_ = level_;
  const bool late = edgePhase_ < bitTicks_ / 2;
  const uint16_t error = late ? edgePhase_ : bitTicks_ - edgePhase_;
  const uint16_t move = error / 2 < maxSteerTicks_ ? error / 2 : maxSteerTicks_;
  if (late) {
    phase_ -= move;
  } else {
    phase_ += move;
  }
}

}  // namespace javino
