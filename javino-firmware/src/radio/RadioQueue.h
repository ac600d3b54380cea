#pragma once

#include <stdint.h>

#include "Radio.h"

namespace javino {

/// Received packets on their way from the interrupt, the only writer, to the loop, the only reader.
///
/// Two packets wait while a third is being received. Neither side ever waits for the other: a slot belongs to the
/// reader while its length is not 0, and to the writer otherwise, and a length is a single byte.
class RadioQueue {
 public:
  static const uint8_t CAPACITY = 3;

  RadioQueue();

  /// Writer: @return room for 77 bytes, the same until commit(); null where no slot is free.
  uint8_t *claim();

  /// Writer: hands the claimed slot to the reader.
  /// @param length 1…77
  void commit(uint8_t length);

  /// Reader: copies the oldest payload out and frees its slot.
  /// @return its length; 0 where none is waiting.
  uint8_t take(uint8_t *payload);

  /// Reader: forgets all that is waiting.
  void clear();

  bool empty() const { return slots_[readIndex_].length == 0; }

 private:
  struct Slot {
    volatile uint8_t length;
    uint8_t payload[MAX_RADIO_PAYLOAD];
  };

  void release();

  uint8_t writeIndex_;
  uint8_t readIndex_;
  Slot slots_[CAPACITY];
};

}  // namespace javino
