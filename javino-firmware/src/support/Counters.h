#pragma once

#include <stdint.h>

#include "../Config.h"
#include "Clock.h"
#include "Inlining.h"
#include "Part.h"
#include "Trace.h"
#include "Zeroed.h"

namespace javinolib {

/// The counters' numbers (SPEC 4.5).
enum class Counter : uint8_t {
  NO_COUNTER,
#define COUNTER(name, meaning) name,
#include "Counters.def"
#undef COUNTER
  END  ///< one more than the last
};

/// Adds one; the counter stops at the greatest number that it can hold.
template <typename Count>
inline void countUp(Count &counter) {
  if (static_cast<Count>(~counter) != 0) counter++;
}

/// Counts of what was done and dropped on the serial line since the boot, of damage since hello, and of percepts that were left
/// out: all that a board without a radio counts.
class SerialCounters {
 public:
  static bool has(Counter counter) { return indexOf(counter) < COUNT; }

  JAVINO_NOINLINE void count(Counter counter) { countUp(at(counter)); }

  /// Takes note of a time, if it is the longest so far.
  /// @param counter LOOP_MILLIS, PERCEPTS_MILLIS or ACTION_MILLIS
  /// @param began the low half of the clock's milliseconds: what lasts for more than 65 s is not known
  JAVINO_NOINLINE void longest(Counter counter, uint16_t began) {
    const uint16_t millis = static_cast<uint16_t>(static_cast<uint16_t>(clock::millis()) - began);
    config::Count &value = at(counter);
    if (millis > value) value = millis;
  }

  config::Count value(Counter counter) const { return values_[indexOf(counter)]; }

  config::Count &at(Counter counter) { return values_[indexOf(counter)]; }

  static const uint8_t COUNT = static_cast<uint8_t>(Counter::SERIAL_REPEATS) + 1 + 3;

 private:
  static uint8_t indexOf(Counter counter) {
    const uint8_t number = static_cast<uint8_t>(counter);
    if (counter == Counter::PERCEPTS_LEFT_OUT) return 0;
    if (counter >= Counter::LOOP_MILLIS)
      return static_cast<uint8_t>(number - static_cast<uint8_t>(Counter::LOOP_MILLIS) + 5);
    return counter <= Counter::SERIAL_REPEATS ? number : COUNT;
  }

  config::Count values_[COUNT] JAVINO_ZEROED;
};

/// The same, and what a board with a radio does and drops; nothing is dropped without a count.
class Counters {
 public:
  static const uint8_t COUNT = static_cast<uint8_t>(Counter::END) - 1;

  /// Whether the radio counts this one (RadioCounters).
  static bool isRadios(Counter counter) {
    return (counter >= Counter::RADIO_RECEIVED && counter <= Counter::RADIO_MISSED) || counter == Counter::RADIO_SENT ||
           counter == Counter::RADIO_MENDED || counter >= Counter::RADIO_LATE_MICROS;
  }

  SerialCounters &serial() { return serial_; }

  /// @param counter none of the radio's
  JAVINO_NOINLINE void count(Counter counter) {
    trace::tell(trace::COUNT, static_cast<uint8_t>(counter));
    countUp(at(counter));
  }

  /// @param counter none of the radio's
  config::Count value(Counter counter) const { return const_cast<Counters *>(this)->at(counter); }

 private:
  static const uint8_t RADIOS = 8;
  static const uint8_t FIRST = static_cast<uint8_t>(Counter::RADIO_BAD_FRAMES);

  // The radio's have no place.
  JAVINO_NOINLINE config::Count &at(Counter counter) {
    if (SerialCounters::has(counter)) return serial_->at(counter);
    uint8_t index = static_cast<uint8_t>(static_cast<uint8_t>(counter) - FIRST);
    if (counter > Counter::RADIO_SENT) index = static_cast<uint8_t>(index - 2);
    if (counter > Counter::RADIO_MENDED) index--;
    return values_[index];
  }

  OwnPart<SerialCounters> serial_;
  config::Count values_[COUNT - RADIOS - SerialCounters::COUNT] JAVINO_ZEROED;
};

}  // namespace javinolib
