#pragma once

#include <stdint.h>

#include "../storage/BootEpoch.h"
#include "../support/NoInline.h"

namespace javino {

/// Gives each nonce once: boot epoch and a counter of sealed frames (SPEC 5.1).
class NonceSource {
 public:
  explicit NonceSource(const BootEpoch &epoch) : epoch_(epoch), counter_(0) {}

  /// Whether epoch or counter is used up: nothing can be sealed until the next boot; after the last epoch never
  /// again on this board.
  bool isExhausted() const { return epoch_.value() == BootEpoch::NONE_LEFT || counter_ > LAST_COUNTER; }

  /// Whether the epoch could be stored: where not, a nonce might come again after the next boot, so none is given.
  bool isStored() const { return epoch_.isStored(); }

  /// Writes the next nonce. To be called only while it is stored and not exhausted.
  /// @param nonce room for 6 bytes
  void take(uint8_t *nonce);

  /// Goes on above the floor of a receiver that lost its memory (SPEC 7.3), unless all to come are above it anyway.
  /// @param floor 6 bytes
  /// @return false, and nothing is changed, where it is of another epoch or more than 32 above the next nonce: no receiver
  ///         of our frames has such a floor, and nonces are not to be used up by it.
  JAVINO_NOINLINE bool raiseAbove(const uint8_t *floor);

 private:
  static const uint32_t LAST_COUNTER = 0xFFFFFF;
  static const uint8_t MOST_ABOVE = 32;

  const BootEpoch &epoch_;
  uint32_t counter_;
};

}  // namespace javino
