#pragma once

#include <stdint.h>

#include "../Config.h"
#include "Inlining.h"
#include "Zeroed.h"

namespace javinolib {

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
  RADIO_FRAGMENTS_DROPPED,
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
  RADIO_DOUBTFUL,
  RADIO_ANSWERS_TOLERATED,
  RADIO_OVERHEARD_DROPPED,
  RELAY_COPIES,
  RELAY_ANSWERS,
  RELAY_REFUSED,
  MEMORY_DAMAGED,
  END  ///< one more than the last
};

/// Adds one; the counter stops at the greatest number that it can hold.
template <typename Count>
inline void countUp(Count &counter) {
  if (static_cast<Count>(~counter) != 0) counter++;
}

/// What was done, damaged and dropped since the boot; nothing is dropped without a count. Where Config.h leaves statistics
/// out, count() does nothing, and there are no values.
class Counters {
 public:
  static const uint8_t COUNT = static_cast<uint8_t>(Counter::END) - 1;

  /// Whether the radio counts this one (RadioCounters).
  static bool isRadios(Counter counter) {
    return (counter >= Counter::RADIO_RECEIVED && counter <= Counter::RADIO_MISSED) || counter == Counter::RADIO_SENT ||
           counter == Counter::RADIO_MENDED;
  }

  /// @param counter none of the radio's

  JAVINO_NOINLINE void count(Counter counter) {
    if (config::STATISTICS) countUp(values_[indexOf(counter)]);
  }

  /// @param counter none of the radio's
  void set(Counter counter, uint32_t value) { values_[indexOf(counter)] = static_cast<Value>(value); }

  /// @param counter none of the radio's
  uint32_t value(Counter counter) const { return values_[indexOf(counter)]; }

 private:
  static const uint8_t RADIOS = 5;

  // The radio's have no place.
  static uint8_t indexOf(Counter counter) {
    uint8_t index = static_cast<uint8_t>(static_cast<uint8_t>(counter) - 1);
    if (counter > Counter::RADIO_MISSED) index = static_cast<uint8_t>(index - 3);
    if (counter > Counter::RADIO_SENT) index--;
    if (counter > Counter::RADIO_MENDED) index--;
    return index;
  }

  // 50 bytes of an Uno's RAM less.
  typedef JAVINO_BY_CHIP(uint32_t, uint16_t) Value;

  Value values_[config::STATISTICS ? COUNT - RADIOS : 1] JAVINO_ZEROED;
};

}  // namespace javinolib
