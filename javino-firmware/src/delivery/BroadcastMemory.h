#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Knows a broadcast that its sender repeats, as nothing in it tells (SPEC 7.2): byte for byte one of the last few of all,
/// begun within 400 ms of that one's end; or a relay's copy of it. Remembers bytes by their CRC.
class BroadcastMemory {
 public:
  /// Takes note of a broadcast that has come whole.
  /// @param frame all of it
  /// @param now when it ended, in ms
  /// @param age how long ago its sender began it at most, in ms
  /// @return whether it is a repeat
  bool isRepeat(const uint8_t *frame, Length length, uint32_t now, uint16_t age);

 private:
  static const uint8_t CAPACITY = config::RECENT_BROADCASTS;

  struct Entry {
    uint16_t crc;
    uint32_t repeatsUntil;
  };

  // An unused place is that of a broadcast with the CRC 0 before the boot. One that is taken for its repeat is as likely as
  // two in a row that have the same CRC.
  Entry entries_[CAPACITY] JAVINO_ZEROED;
  uint8_t oldest_ JAVINO_ZEROED;
};

}  // namespace javinolib
