#pragma once

#include <random>

#include "support/Decoder.h"

// What becomes of packets with random bit errors: they come intact, or mended, or are lost, or - never - come wrong.
struct Damage {
  unsigned packets = 0, untouched = 0, intact = 0, mended = 0, wrong = 0;

  unsigned damaged() const { return packets - untouched; }

  // Each bit is wrong with this probability.
  void tryPacket(const Bytes &payload, double rate, std::mt19937 &random) {
    Bits bits = reference::packetBits(payload);
    std::geometric_distribution<size_t> distance(rate);
    bool touched = false;
    for (size_t i = distance(random); i < bits.size(); i += 1 + distance(random)) {
      bits[i] = !bits[i];
      touched = true;
    }
    packets++;
    if (!touched) untouched++;
    decoder_.add(bits);
    decoder_.endOfSignal();
    for (javino::RadioPacket packet = decoder_.take(); packet.bytes[0] != 0; packet = decoder_.take())
      judge(packet, payload);
  }

 private:
  void judge(javino::RadioPacket packet, const Bytes &payload) {
    const bool complete = packet.wrongNibble == javino::RadioPacket::NO_NIBBLE;
    if (!(complete ? packet.isIntact() : packet.mend())) return;
    const bool right = Bytes(packet.payload(), packet.payload() + packet.payloadLength()) == payload;
    unsigned &counter = !right ? wrong : complete ? intact : mended;
    counter++;
  }

  Decoder decoder_;
};
