#pragma once

#include <cstdint>
#include <vector>

/// The counts of an attack.
struct Tally {
  uint64_t tries = 0;     ///< hostile packets, or messages in fragments
  uint64_t accepted = 0;  ///< how often one of them was taken for genuine
  uint64_t genuine = 0;   ///< messages in between that ought to arrive: what refuses all has shown nothing
  uint64_t lost = 0;      ///< of these
};

/// One way to attack a board; all random numbers come from the seed.
struct Attack {
  const char *name;
  /// Goes on until there were this many tries or a few more.
  Tally (*run)(uint32_t seed, uint64_t tries);
};

/// All of them.
const std::vector<Attack> &allAttacks();
