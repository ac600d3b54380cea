#pragma once

#include <stdint.h>

#include "../support/Status.h"
#include "../storage/BootEpoch.h"
#include "../storage/Retained.h"
#include "../support/Inlining.h"
#include "../support/Zeroed.h"
#include "../support/Part.h"

namespace javinolib {

/// Gives each nonce once: boot epoch and a counter of sealed frames (SPEC 5.1), as long as the memory beside the stack holds
/// (Retained.h): what ran over that may have changed the counter too.
class NonceSource {
 public:
  explicit NonceSource(BootEpoch &epoch) : epoch_(epoch) {}

  /// The first half of the nonces to come.
  Uint24 epoch() const { return epoch_->value(); }

  /// Goes on with another epoch, and the counter 0, where that is higher: the next boot then takes over what RAM holds if it is
  /// the one after this.
  /// @param epoch 0…0xFFFFFE
  void raiseEpoch(Uint24 epoch);

  /// OK; EPOCH_LOST until a host raises the epoch; MEMORY_DAMAGED where the counter is not known; NONCE_EXHAUSTED where epoch or counter is used up: nothing can be sealed until the next boot, after the last epoch
  /// never again on this board; STORE_FAILED where the epoch was not kept: a nonce might come again after the next boot.
  JAVINO_NOINLINE Status status() const;

  /// Writes the next nonce. To be called only while status() is OK.
  /// @param nonce room for 6 bytes
  void take(uint8_t *nonce);

  /// Goes on above the floor of a receiver that lost its memory (SPEC 7.3), unless all to come are above it anyway.
  /// @param floor 6 bytes
  /// @param nonce 6 bytes, one that was given, of the frame that was refused for the floor
  /// @return false, and nothing is changed, where the floor is of another epoch or more than 31 above the nonce: no
  ///         receiver has such a floor, and nonces are not to be used up by it, however often it is told.
  bool raiseAbove(const uint8_t *floor, const uint8_t *nonce);

 private:
  static const uint32_t LAST_COUNTER = 0xFFFFFF;
  static const uint8_t MOST_ABOVE = 31;  // as ReplayMemory sets a floor above the nonce that it is written for

  Part<BootEpoch> epoch_;
  uint32_t counter_ JAVINO_ZEROED;
};

#ifdef __AVR__
template <>
NonceSource &Part<NonceSource>::the();
#endif

}  // namespace javinolib
