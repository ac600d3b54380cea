#pragma once

#include <stdint.h>

#include "../framing/Crc16.h"
#include "OutOfLine.h"
#include "RadioQueue.h"
#include "Radio.h"

namespace javino {

/// Finds radio packets (SPEC 6) in a stream of bits and queues those with a right CRC.
///
/// Each packet whose start symbol was found is counted once: received, damaged or missed. After a damaged one the hunt
/// for a start symbol goes on at the very next bit.
class RadioDecoder {
 public:
  RadioDecoder(RadioQueue &queue, RadioCounters &counters);

  /// Takes the next bit from the air.
  JAVINO_OUT_OF_LINE void add(bool bit);

  /// Forgets all bits; a packet under way counts as missed, since it is the receiver that leaves it.
  void abandon();

 private:
  void addSymbol(uint8_t symbol);
  void addByte(uint8_t byte);
  void startPacket(uint8_t count);
  void endPacket();
  void refuse();
  void hunt();

  RadioQueue &queue_;
  RadioCounters &counters_;
  uint16_t bits_;        // the last twelve, the newest at the top
  bool hunting_;         // for a start symbol
  uint8_t symbolBits_;   // bits of the symbol under way
  bool lowNibble_;       // the next nibble is a byte's second
  uint8_t highNibble_;
  uint8_t count_;        // bytes of the packet, itself included; 0 until it came
  uint8_t received_;     // bytes so far
  uint8_t *payload_;     // where they go; null where no slot was free
  Crc16 crc_;
};

}  // namespace javino
