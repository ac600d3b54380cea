#pragma once

#include <stdint.h>

#include "../framing/Address.h"
#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Messages in fragments of which no fragment is of use: they are for others, or here already. Each is ignored until none of
/// its fragments has come for long; when more come than there is room for, the oldest goes.
class IgnoredMessages {
 public:
  JAVINO_NOINLINE void add(const Address &origin, uint8_t id, uint16_t now);
  void remove(const Address &origin, uint8_t id);

  /// Whether a fragment is of such a message, which is then ignored for longer.
  bool covers(const Address &origin, uint8_t id, uint16_t now);

  /// To be called at least once a second.
  /// @param after ms without a fragment, at most 60 000
  void expire(uint16_t now, uint16_t after);

 private:
  static const uint8_t CAPACITY = 4;
  static const uint8_t FREE = 0;
  static const uint8_t USED = 0x40;  // beside an id, 0…63

  struct Entry {
    uint8_t mark;  // FREE, or USED and the id
    Address origin;
    uint16_t lastFragment;
  };

  JAVINO_NOINLINE Entry *find(const Address &origin, uint8_t id);

  Entry entries_[CAPACITY] JAVINO_ZEROED;
  uint8_t oldest_ JAVINO_ZEROED;
};

}  // namespace javinolib
