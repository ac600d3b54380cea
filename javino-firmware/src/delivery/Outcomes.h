#pragma once

#include <stdint.h>
#include <string.h>

#include "../framing/Limits.h"
#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javino {

/// How a transmission ended (SPEC 4.3, record T).
enum class Outcome : uint8_t {
  SENT = 0,        ///< a broadcast or multicast has been on the air
  DELIVERED = 1,   ///< the receiver's host has taken a unicast
  UNDELIVERED = 2  ///< it is not known to have; or what was accepted could not be sealed when its turn came
};

/// The outcomes of transmissions, in the order in which they ended, until the host has had them (SPEC 4.3).
class Outcomes {
 public:
  /// Transmissions without a reported outcome, at most: a host that never polls gets QUEUE_FULL instead of losing
  /// outcomes. All of them fit a poll reply, with 5 bytes each.
  static const uint8_t MAX_UNREPORTED = 2 + 5 * 32 <= MAX_MESSAGE_LENGTH ? 32 : 8;

  struct End {
    uint8_t number;  ///< of the transmission
    Outcome outcome;
  };

  /// How many have ended that the host is not known to know of.
  uint8_t count() const { return count_; }

  /// A transmission has ended. Only while there are fewer than MAX_UNREPORTED.
  void add(uint8_t number, Outcome outcome) {
    End &end = ends_[count_++];
    end.number = number;
    end.outcome = outcome;
  }

  /// Whether outcomes are to be told.
  bool areUntold() const { return told_ != count_; }

  /// The next one to be told, which is told now. Only while there is one.
  const End &tell() { return ends_[told_++]; }

  /// The host has had all that was told.
  void forgetTold() {
    count_ = static_cast<uint8_t>(count_ - told_);
    memmove(ends_, ends_ + told_, count_ * sizeof(End));
    told_ = 0;
  }

  /// The host may not have had it.
  void keepTold() { told_ = 0; }

 private:
  static_assert(2 + 5 * MAX_UNREPORTED <= MAX_MESSAGE_LENGTH, "a poll reply tells all outcomes");

  uint8_t count_ JAVINO_ZEROED;
  uint8_t told_ JAVINO_ZEROED;
  End ends_[MAX_UNREPORTED];
};

}  // namespace javino
