#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Finds the bits in a line that is known by its changes of level: a phase-locked loop with integrate-and-dump.
///
/// The line is cut into windows of one bit. A bit is one where the line was high for more than half of its window, so
/// that a short pulse of noise flips nothing. Each change of level whose new level lasts a quarter of a bit steers the
/// windows so that their borders fall on such changes: by half of the error, by an eighth of a bit at most. That
/// follows a sender whose clock is 3 % off through four equal bits, the most that the line code holds.
class BitClock {
 public:
  static const uint8_t MIN_TICKS = 16;

  /// @param bitTicks the length of a bit in ticks, 16…13107
  explicit BitClock(uint16_t bitTicks);

  /// Starts a window now, with the line at this level.
  void reset(bool level);

  /// Goes on in time, at most to the end of the window.
  /// @param ticks how long the line was at this level, from change to change (a level that stays may come in parts of
  /// a quarter of a bit or more); on return, how much of that is still to be gone through
  /// @param bit set where a window ended
  /// @return whether a window ended; to be called again as long as one did.
  bool advance(uint16_t &ticks, bool level, bool &bit);

 private:
  void steer();

  const uint16_t bitTicks_;
  uint16_t phase_ JAVINO_ZEROED;    // ticks since the window began, moved by steering
  int16_t balance_ JAVINO_ZEROED;   // ticks high less ticks low in this window
  bool steadyLevel_ JAVINO_ZEROED;  // the last level that was no glitch
};

}  // namespace javinolib
