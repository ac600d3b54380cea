#pragma once

#include <stdint.h>

#include "CarrierSense.h"
#include "../support/Inlining.h"
#include "Radio.h"
#include "RadioQueue.h"
#include "../support/Zeroed.h"

namespace javino {

/// Finds radio packets (SPEC 6) in a stream of bits and queues them, their CRC unread.
///
/// Each packet whose start symbol was found is counted as damaged or missed, or is queued. One symbol outside of the
/// table is let pass behind the count, where it may be mended. After a damaged packet the hunt for a start symbol goes
/// on at the very next bit.
class RadioDecoder {
 public:
  /// @param bitTicks the length of a bit in ticks, 16…13107
  explicit RadioDecoder(uint16_t bitTicks);

  /// Takes the next bit from the air.
  JAVINO_OUT_OF_LINE void add(bool bit);

  /// @return whether a packet is under way whose count has come.
  bool inPacket() const { return count_ != 0; }

  /// The line has been silent for longer than the line code allows: a packet under way is damaged.
  void endOfSignal();

  /// Forgets all bits; a packet under way counts as missed, since it is the receiver that leaves it.
  void abandon();

  CarrierSense &carrier() { return carrier_; }
  const CarrierSense &carrier() const { return carrier_; }
  RadioCounters &counters() { return counters_; }
  const RadioCounters &counters() const { return counters_; }
  RadioQueue &queue() { return queue_; }
  const RadioQueue &queue() const { return queue_; }

 private:
  void addSymbol(uint8_t symbol);
  bool mayBeMended(uint8_t symbol) const;
  void addByte(uint8_t byte);
  void startPacket(uint8_t count);
  void endPacket();
  void refuse();
  void hunt();

  uint16_t bits_ JAVINO_ZEROED;       // the last twelve, the newest at the top
  bool hunting_;                      // for a start symbol
  uint8_t symbolBits_ JAVINO_ZEROED;  // bits of the symbol under way
  bool lowNibble_ JAVINO_ZEROED;      // the next nibble is a byte's second
  uint8_t highNibble_ JAVINO_ZEROED;
  uint8_t count_ JAVINO_ZEROED;     // bytes of the packet, itself included; 0 until it came
  uint8_t received_ JAVINO_ZEROED;  // bytes so far
  uint8_t wrongNibble_;             // as in RadioPacket
  uint8_t wrongSymbol_ JAVINO_ZEROED;
  RadioPacket *packet_ JAVINO_ZEROED;  // where all goes; null where no slot was free
  CarrierSense carrier_;
  RadioCounters counters_ JAVINO_ZEROED;
  RadioQueue queue_;  // last: AVR reaches only the first 64 bytes of an object in one instruction
};

}  // namespace javino
