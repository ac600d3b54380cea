#pragma once

#include "radio/RadioDecoder.h"
#include "support/ReferencePacket.h"

// A decoder with its queue and its counters.
class Decoder {
 public:
  Decoder() : counters(), decoder_(queue_, counters) {}

  void add(const Bits &bits) {
    for (bool bit : bits) decoder_.add(bit);
  }

  void abandon() { decoder_.abandon(); }

  Bytes take() {
    uint8_t payload[77];
    const uint8_t length = queue_.take(payload);
    return Bytes(payload, payload + length);
  }

  javino::RadioCounters counters;

 private:
  javino::RadioQueue queue_;
  javino::RadioDecoder decoder_;
};
