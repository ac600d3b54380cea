#pragma once

#include <stdint.h>

#include "../framing/Limits.h"
#include "PendingReports.h"

namespace javinolib {

/// How a transmission ended (SPEC 4.3, record T).
enum class Outcome : uint8_t {
  SENT = 0,        ///< a broadcast or multicast has been on the air
  DELIVERED = 1,   ///< the receiver's host has taken a unicast
  UNDELIVERED = 2  ///< it is not known to have; or what was accepted could not be sealed when its turn came
};

/// The end of a transmission.
struct TransmissionEnd {
  uint8_t number;  ///< of the transmission
  Outcome outcome;
};

/// The outcomes of transmissions.
class Outcomes : public PendingReports<TransmissionEnd, 2 + 5 * 32 <= MAX_MESSAGE_LENGTH ? 32 : 8> {
 public:
  /// Transmissions without a reported outcome, at most: a host that never polls gets QUEUE_FULL instead of losing
  /// outcomes. All of them fit a poll reply, with 5 bytes each.
  static const uint8_t MAX_UNREPORTED = CAPACITY;
  static_assert(2 + 5 * MAX_UNREPORTED <= MAX_MESSAGE_LENGTH, "a poll reply tells all outcomes");

  /// A transmission has ended. Only while there are fewer than MAX_UNREPORTED.
  void add(uint8_t number, Outcome outcome) {
    TransmissionEnd &end = append();
    end.number = number;
    end.outcome = outcome;
  }
};

}  // namespace javinolib
