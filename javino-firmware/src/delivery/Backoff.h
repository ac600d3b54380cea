#pragma once

#include <stdint.h>

#include "../support/Random.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// How long a sender waits before it begins, counted in quiet slots (SPEC 7.4).
///
/// The random part comes from a window that fits the number of boards that want to send. Nobody knows that number, but
/// each board hears how many slots stay idle before somebody begins: few where many contend. The window grows while
/// they are few and shrinks while they are many (Heusse and others, *Idle Sense*, 2005). All boards hear the same, so
/// their windows are alike.
///
/// A board knows a hidden sender by acknowledgements to packets that it does not hear, and takes turns with it.
class Backoff {
 public:
  Backoff();

  /// Takes notice of the air; to be called each time the medium was looked at.
  /// @param quietSlots how long the air has been quiet by now, as MediumAccess counts
  void listen(uint8_t quietSlots);

  /// Begins a wait: 6 quiet slots and a random number of further ones; none where what is to be sent is new and the
  /// air has been quiet for long.
  /// @param attempt 0 for what is new
  /// @param quietSlots how long the air has been quiet by now
  void begin(uint8_t attempt, uint8_t quietSlots, Random &random);

  /// Counts on; to be asked each time the medium was looked at.
  /// @return whether the wait is over
  bool isOver(uint8_t quietSlots);

  /// Slots to wait beyond the first ones.
  uint8_t left() const { return left_; }

  /// Another device was acknowledged: our turn, where a hidden sender is known.
  /// @return whether the wait was drawn anew
  bool otherAcknowledged(Random &random);

  /// A unicast of ours was acknowledged: the hidden sender's turn, where one is known.
  void acknowledged() { hidden_ = static_cast<uint8_t>(hidden_ << 1); }

 private:
  uint16_t window_;                // of a first attempt, in parts of a slot
  uint8_t quiet_ JAVINO_ZEROED;    // quiet slots when listened to last; while the air is busy, those before
  uint8_t hidden_ JAVINO_ZEROED;   // a bit for each unicast for which a hidden sender stays known
  uint8_t left_ JAVINO_ZEROED;     // slots to wait beyond the first ones
  uint8_t counted_ JAVINO_ZEROED;  // quiet slots of the present quiet that were counted, or lay before
};

}  // namespace javinolib
