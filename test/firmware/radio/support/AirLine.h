#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "ReferencePacket.h"

// A receiver's data pin over time: levels, each held for some ticks.
class AirLine {
 public:
  struct Run {
    bool level;
    double ticks;
  };

  // Bits of this length; a sender whose clock is 3 % slow has bits 3 % longer.
  AirLine &bits(const Bits &bits, double bitTicks);

  AirLine &hold(bool level, double ticks);
  AirLine &silence(double ticks) { return hold(false, ticks); }

  // Pulses of random lengths up to the given one, as a receiver without a carrier gives them.
  AirLine &noise(double ticks, double longestPulse, std::mt19937 &random);

  // Moves each change of level by up to so much, either way.
  AirLine &jitter(double ticks, std::mt19937 &random);

  // Inverts the line for a moment about once in so many ticks.
  AirLine &glitches(double length, double meanDistance, std::mt19937 &random);

  // Moves each change of level to the next multiple of so many ticks.
  AirLine &quantise(double ticks);

  const std::vector<Run> &runs() const { return runs_; }
  bool levelAt(double time) const;
  double duration() const;

 private:
  std::vector<double> changes() const;
  void rebuild(const std::vector<double> &changes);

  std::vector<Run> runs_;  // of alternating levels, the first one low (and perhaps empty)
};
