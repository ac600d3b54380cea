#pragma once

#include <stdint.h>

#include "../framing/Address.h"
#include "../support/Inlining.h"

namespace javino {

/// Messages in pieces of which no piece is of use: they are for others, or here already. Each is ignored until none of
/// its pieces has come for 5 s; when more come than there is room for, the oldest goes.
class IgnoredMessages {
 public:
  IgnoredMessages();

  JAVINO_NOINLINE void add(const Address &origin, uint8_t id, uint16_t now);
  void remove(const Address &origin, uint8_t id);

  /// Whether a piece is of such a message, which is then ignored for longer.
  bool covers(const Address &origin, uint8_t id, uint16_t now);

  /// To be called at least once a minute.
  void expire(uint16_t now);

 private:
  static const uint8_t CAPACITY = 4;
  static const uint8_t FREE = 0xFF;

  struct Entry {
    uint8_t id;  // FREE where unused
    Address origin;
    uint16_t lastPiece;
  };

  JAVINO_NOINLINE Entry *find(const Address &origin, uint8_t id);

  Entry entries_[CAPACITY];
  uint8_t oldest_;
};

}  // namespace javino
