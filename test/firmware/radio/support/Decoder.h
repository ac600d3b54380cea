#pragma once

#include "radio/RadioDecoder.h"
#include "support/ReferencePacket.h"

const Bytes GOOD = {'g', 'o', 'o', 'd'};

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
  javinolib::RadioPacket take() {
    javinolib::RadioPacket packet = javinolib::RadioPacket();
    javinolib::RadioQueue &queue = decoder_.queue();
    if (!queue.empty()) {
      packet = *queue.oldest();
      queue.release();
    }
    return packet;
  }

  // Its payload, where its CRC is right without mending.
  Bytes takeIntact() {
    javinolib::RadioPacket packet = take();
    if (packet.symbols == 0 || packet.path() >= javinolib::RadioPacket::NO_PATH) return Bytes();
    packet.makeBytes(packet.count());
    return Bytes(packet.payload(), packet.payload() + packet.payloadLength());
  }

  const javinolib::RadioCounters &counters() const { return decoder_.counters(); }
  javinolib::CarrierSense &carrier() { return decoder_.carrier(); }

 private:
  javinolib::RadioDecoder decoder_;
};
