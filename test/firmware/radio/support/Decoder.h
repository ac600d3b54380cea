#pragma once

#include "radio/RadioDecoder.h"
#include "support/ReferencePacket.h"

// A decoder with its queue and its counters.
class Decoder {
 public:
  Decoder() : counters(), carrier(1000), decoder_(queue_, carrier, counters) {}

  void add(const Bits &bits) {
    for (bool bit : bits) decoder_.add(bit);
  }

  void endOfSignal() { decoder_.endOfSignal(); }
  void abandon() { decoder_.abandon(); }

  // The oldest packet that waits; one whose count is 0 where none does.
  javino::RadioPacket take() {
    javino::RadioPacket packet = javino::RadioPacket();
    if (!queue_.empty()) {
      packet = *queue_.oldest();
      queue_.release();
    }
    return packet;
  }

  // Its payload, where its CRC is right without mending.
  Bytes takeIntact() {
    const javino::RadioPacket packet = take();
    if (packet.bytes[0] == 0 || packet.wrongNibble != javino::RadioPacket::NO_NIBBLE || !packet.isIntact())
      return Bytes();
    return Bytes(packet.payload(), packet.payload() + packet.payloadLength());
  }

  javino::RadioCounters counters;
  javino::CarrierSense carrier;

 private:
  javino::RadioQueue queue_;
  javino::RadioDecoder decoder_;
};
