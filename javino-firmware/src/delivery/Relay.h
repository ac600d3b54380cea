#pragma once

#include <stddef.h>
#include <stdint.h>

#include "../radio/Radio.h"
#include "../support/Counters.h"
#include "../support/Part.h"
#include "../support/Random.h"
#include "Forwarding.h"
#include "MediumAccess.h"

namespace javinolib {

/// A board that only relays (SPEC 7.5): messages between devices that do not hear each other reach each other through it. It
/// needs neither a host nor keys nor the EEPROM.
/// On an AVR a global or static object (support/Zeroed.h).
class Relay {
 public:
  static void *operator new(size_t) = delete;

  // The radio outlives the relay.
  explicit Relay(Radio &radio) : medium_(radio), forwarding_(medium_, random_, counters_) {}

  // Starts the radio; call it once, in setup(). Of two relays in range each has another number, 0…65535; it only makes them
  // wait differently. Returns false if the radio does not start, or cannot tell others what is a copy.
  bool begin(uint16_t number = 0);

  // Does all work that is due; call it from loop(), and at least every 5 ms.
  void run();

  // The number of copies since the boot: of messages, and of acknowledgements.
  uint32_t copies() const { return counters_->value(Counter::RELAY_COPIES); }
  uint32_t answers() const { return counters_->value(Counter::RELAY_ANSWERS); }

  // The number of messages that were not copied, since its memory was full or too many went unanswered.
  uint32_t refused() const { return counters_->value(Counter::RELAY_REFUSED); }

  // The share of the time since the boot that the radio has sent, in tenths of a percent.
  uint16_t airtime() const { return seconds_ == 0 ? 0 : static_cast<uint16_t>(1000ul * medium_->airtime() / seconds_); }

 private:
  OwnPart<MediumAccess> medium_;
  OwnPart<Random> random_;
  OwnPart<Counters> counters_;
  Forwarding::Memory memory_ JAVINO_ZEROED;
  Forwarding forwarding_;
  uint32_t seconds_ JAVINO_ZEROED;  // since the boot, as the clock begins anew after 49 days
  uint16_t secondSince_ JAVINO_ZEROED;
};

}  // namespace javinolib
