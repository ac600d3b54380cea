#pragma once

#include <stdint.h>

#include "Inlining.h"

namespace javino {

/// The counters' numbers (SPEC 4.5).
enum class Counter : uint8_t {
  SERIAL_REQUESTS = 1,
  SERIAL_DAMAGED,
  SERIAL_BAD_FRAMES,
  SERIAL_REPEATS,
  RADIO_RECEIVED,
  RADIO_DAMAGED,
  RADIO_MISSED,
  RADIO_BAD_FRAMES,
  RADIO_RESERVED,
  RADIO_NOT_FOR_US,
  RADIO_OWN,
  RADIO_NO_KEY,
  RADIO_BAD_TAG,
  RADIO_REPLAYED,
  RADIO_REPLAY_FULL,
  RADIO_QUEUE_FULL,
  RADIO_SENT,
  PERCEPTS_LEFT_OUT,
  RADIO_REPEATS,
  RADIO_PIECES_DROPPED,
  RADIO_EXPIRED,
  RADIO_ACKNOWLEDGED,
  RADIO_UNDELIVERED,
  RADIO_BAD_PROOFS,
  RADIO_RESENT,
  RADIO_DEFERRED,
  RADIO_STALE,
  RADIO_MENDED,
  RADIO_BLOCKED,
  RADIO_ANSWERS_DROPPED,
  END  ///< one more than the last
};

/// Adds one; the counter stops at 4294967295.
inline void countUp(uint32_t &counter) {
  if (counter != UINT32_MAX) counter++;
}

/// What was done, damaged and dropped since the boot; nothing is dropped without a count.
class Counters {
 public:
  static const uint8_t COUNT = static_cast<uint8_t>(Counter::END) - 1;

  Counters() : values_() {}

  JAVINO_NOINLINE void count(Counter counter) { countUp(values_[indexOf(counter)]); }

  /// Takes over a value that is counted elsewhere.
  void set(Counter counter, uint32_t value) { values_[indexOf(counter)] = value; }

  uint32_t value(Counter counter) const { return values_[indexOf(counter)]; }

 private:
  static uint8_t indexOf(Counter counter) { return static_cast<uint8_t>(static_cast<uint8_t>(counter) - 1); }

  uint32_t values_[COUNT];
};

}  // namespace javino
