#pragma once

#include "radio/RadioDecoder.h"
#include "support/ReferencePacket.h"

// A decoder, and what it has found.
class Decoder {
 public:
  Decoder() : decoder_(1000) {}

  void add(const Bits &bits) {
    for (bool bit : bits) decoder_.add(bit);
  }

  void endOfSignal() { decoder_.endOfSignal(); }
  void abandon() { decoder_.abandon(); }

  // The oldest packet that waits; one without symbols where none does.
  javino::RadioPacket take() {
    javino::RadioPacket packet = javino::RadioPacket();
    javino::RadioQueue &queue = decoder_.queue();
    if (!queue.empty()) {
      packet = *queue.oldest();
      queue.release();
    }
    return packet;
  }

  // Its payload, where its CRC is right without mending.
  Bytes takeIntact() {
    javino::RadioPacket packet = take();
    if (packet.symbols == 0 || packet.hops() >= javino::RadioPacket::NO_HOPS) return Bytes();
    packet.makeBytes(packet.count());
    return Bytes(packet.payload(), packet.payload() + packet.payloadLength());
  }

  const javino::RadioCounters &counters() const { return decoder_.counters(); }
  javino::CarrierSense &carrier() { return decoder_.carrier(); }

 private:
  javino::RadioDecoder decoder_;
};
