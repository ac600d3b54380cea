#pragma once

#include <stdint.h>

#include "../framing/Limits.h"
#include "../support/Zeroed.h"

namespace javino {

/// How a transmission ended (SPEC 4.3, record T).
enum class Outcome : uint8_t {
  SENT = 0,        ///< a broadcast or multicast has been on the air
  DELIVERED = 1,   ///< the receiver's host has taken a unicast
  UNDELIVERED = 2  ///< it is not known to have; or what was accepted could not be sealed when its turn came
};

/// The numbers of transmissions, and their outcomes until the host has had them (SPEC 4.3). Transmissions end in the order
/// of their numbers.
class Outcomes {
 public:
  /// Transmissions without a reported outcome, at most: a host that never polls gets QUEUE_FULL instead of losing
  /// outcomes. All of them fit a poll reply, with 5 bytes each. Divides 256.
  static const uint8_t MAX_UNREPORTED = 2 + 5 * 32 <= MAX_MESSAGE_LENGTH ? 32 : 16;

  /// Whether there is no number for another transmission.
  bool isFull() const { return static_cast<uint8_t>(nextNumber_ - first_) >= MAX_UNREPORTED; }

  /// Numbers a transmission. Only while it is not full.
  uint8_t open() { return nextNumber_++; }

  /// The oldest transmission that has not ended ends.
  void close(Outcome outcome) { outcomes_[nextEnded_++ % MAX_UNREPORTED] = outcome; }

  /// The first transmission whose outcome is to be told, or has not ended.
  uint8_t first() const { return nextTold_; }

  /// The first transmission that has not ended: those from first() to the one before it have.
  uint8_t end() const { return nextEnded_; }

  /// How a transmission ended that has.
  Outcome of(uint8_t number) const { return outcomes_[number % MAX_UNREPORTED]; }

  /// All outcomes have been written into a reply.
  void markTold() { nextTold_ = nextEnded_; }

  /// The host has had that reply.
  void forgetTold() { first_ = nextTold_; }

  /// The host may not have had that reply.
  void keepTold() { nextTold_ = first_; }

 private:
  uint8_t nextNumber_ JAVINO_ZEROED;
  uint8_t nextEnded_ JAVINO_ZEROED;
  uint8_t nextTold_ JAVINO_ZEROED;
  uint8_t first_ JAVINO_ZEROED;
  static_assert(2 + 5 * MAX_UNREPORTED <= MAX_MESSAGE_LENGTH, "a poll reply tells all outcomes");

  Outcome outcomes_[MAX_UNREPORTED];
};

}  // namespace javino
