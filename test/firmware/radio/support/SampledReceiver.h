#pragma once

#include <vector>

#include "AirLine.h"

// VirtualWire's receiver, written anew from its description: the line is sampled eight times a bit; a ramp of 160 steps
// advances by 20 a sample, by 11 or 29 where the line changed in the first or second half of the bit; a bit is one where
// five of its samples or more are. It stands for the boards that exist already.
class SampledReceiver {
 public:
  // Samples the whole line, at the receiver's own idea of a bit.
  // Returns the payloads of all packets with a right CRC.
  static std::vector<Bytes> receive(const AirLine &line, double bitTicks);

 private:
  void sample(bool level);
  void addBit(bool bit);

  std::vector<Bytes> payloads_;
  bool last_ = false;
  int ramp_ = 0;
  int ones_ = 0;
  unsigned bits_ = 0;
  bool active_ = false;
  int bitCount_ = 0;
  Bytes packet_;
};
