#pragma once

#include <stdint.h>

#include "../Config.h"
#include "RadioPacket.h"

namespace javino {

/// Packets on their way from the interrupt, the only writer, to the loop, the only reader.
///
/// All packets but one wait while the last is being received. Neither side ever waits for the other: a slot belongs to the
/// reader while it is marked full, and to the writer otherwise.
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

  bool empty() const { return !slots_[readIndex_].full; }

 private:
  struct Slot {
    volatile bool full;
    RadioPacket packet;
  };

  uint8_t writeIndex_;
  uint8_t readIndex_;
  Slot slots_[CAPACITY];
};

}  // namespace javino
