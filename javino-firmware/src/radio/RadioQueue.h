#pragma once

#include <stdint.h>

#include "../Config.h"
#include "RadioPacket.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Packets on their way from the interrupt, the only writer, to the loop, the only reader.
///
/// All packets but one wait while the last is being received. Neither side ever waits for the other: a slot belongs to the
/// reader while it is marked full, and to the writer otherwise. Only what comes behind a packet is still written to a full one.
class RadioQueue {
 public:
  static const uint8_t CAPACITY = config::RADIO_PACKETS;

  RadioQueue();

  /// Writer: @return room for a packet, the same until commit(); null where no slot is free.
  RadioPacket *claim();

  /// Writer: hands the claimed packet to the reader.
  void commit();

  /// Reader: @return the oldest packet, its own until release(); null where none is waiting.
  RadioPacket *oldest();

  /// Reader: frees the oldest packet's slot.
  void release();

  bool empty() const { return !read_->full; }

 private:
  struct Slot {
    volatile bool full JAVINO_ZEROED;
    RadioPacket packet;
  };

  Slot *following(Slot *slot) { return slot + 1 == slots_ + CAPACITY ? slots_ : slot + 1; }

  Slot *write_;
  Slot *read_;
  Slot slots_[CAPACITY];
};

}  // namespace javinolib
