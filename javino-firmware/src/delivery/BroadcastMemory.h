#pragma once

#include <stdint.h>

#include "../framing/Address.h"

namespace javino {

/// Knows a broadcast that its sender repeats, as nothing in it tells (SPEC 7.2): byte for byte the last one of its origin,
/// begun within 400 ms of that one's end. Remembers the last few origins; bytes by their CRC.
class BroadcastMemory {
 public:
  BroadcastMemory();

  /// Takes note of a broadcast that has come whole.
  /// @param frame all of it
  /// @param begun when it began, in ms
  /// @param now when it ended
  /// @return whether it is a repeat
  bool isRepeat(const Address &origin, const uint8_t *frame, uint16_t length, uint32_t begun, uint32_t now);

 private:
  static const uint8_t CAPACITY = 4;

  struct Entry {
    Address origin;  // `++++` where unused
    uint16_t crc;
    uint32_t ended;
  };

  uint8_t placeFor(const Address &origin);

  Entry entries_[CAPACITY];
  uint8_t oldest_;
};

}  // namespace javino
