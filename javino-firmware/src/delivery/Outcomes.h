#pragma once

#include <stdint.h>

namespace javino {

/// How a transmission ended (SPEC 4.3, record T).
enum class Outcome : uint8_t {
  SENT = 0,        ///< a broadcast or multicast has been on the air
  DELIVERED = 1,   ///< the receiver's host has taken a unicast
  UNDELIVERED = 2  ///< it is not known to have; or what was accepted could not be sealed when its turn came
};

/// The numbers of transmissions, and their outcomes until they are polled. Transmissions end in the order of their
/// numbers.
class Outcomes {
 public:
  /// Transmissions without a reported outcome, at most: a host that never polls gets QUEUE_FULL instead of losing
  /// outcomes. So many take 160 bytes of a poll reply.
  static const uint8_t MAX_UNREPORTED = 32;

  Outcomes() : nextNumber_(0), nextEnded_(0), nextReported_(0) {}

  /// Whether there is no number for another transmission.
  bool isFull() const { return static_cast<uint8_t>(nextNumber_ - nextReported_) >= MAX_UNREPORTED; }

  /// Numbers a transmission. Only while it is not full.
  uint8_t open() { return nextNumber_++; }

  /// The oldest transmission that has not ended ends.
  void close(Outcome outcome) { outcomes_[nextEnded_++ % MAX_UNREPORTED] = outcome; }

  /// Whether outcomes wait to be reported.
  bool isWaiting() const { return nextReported_ != nextEnded_; }

  /// Takes the oldest. Only while one is waiting.
  /// @param outcome of this transmission
  /// @return its number
  uint8_t take(Outcome &outcome) {
    outcome = outcomes_[nextReported_ % MAX_UNREPORTED];
    return nextReported_++;
  }

 private:
  uint8_t nextNumber_;
  uint8_t nextEnded_;
  uint8_t nextReported_;
  Outcome outcomes_[MAX_UNREPORTED];
};

}  // namespace javino
