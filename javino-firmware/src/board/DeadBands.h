#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../support/Flash.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// The values last told of percepts that have a dead band or a least interval of their own. A percept is known by the place
/// of its name in flash; among percepts of one name in a reading, by their order.
class DeadBands {
 public:
  /// To be called before each reading. A percept that the last reading lacked is forgotten.
  /// @param anew all others too: the host knows no reading, or asks for the values as they are
  void begin(bool anew);

  /// What to tell of a percept: the value last told, until the new one differs from it by the dead band or more, and it has
  /// been told for the least time. A percept that is new, or for which no place is left, is told as it is.
  long settle(const FlashText *name, long number, unsigned long deadBand, unsigned long leastMillis);

 private:
  struct Entry {
    const FlashText *name;  // null where the place is free
    bool seen;              // in the reading under way
    long told;
    uint32_t changedAt;
  };

  Entry entries_[config::DEAD_BANDS] JAVINO_ZEROED;
};

}  // namespace javinolib
