#pragma once

#include "../storage/BootEpoch.h"
#include "../storage/KeyStore.h"
#include "../storage/RfId.h"
#include "../support/Counters.h"
#include "../support/Inlining.h"
#include "../support/Random.h"
#include "NonceSource.h"
#include "ReplayMemory.h"

namespace javinolib {

/// What many parts of a board need: who it is, its keys and nonces, random numbers and counters.
///
/// Each part has one reference to all of it: with one to each that it needs, a board took 40 bytes more of RAM and 250 of
/// flash on an AVR.
struct BoardState {
  BoardState() : nonces(epoch), replays(keys) {}

  JAVINO_OUT_OF_LINE void count(Counter counter) { counters.count(counter); }

  RfId id;
  Random random;
  BootEpoch epoch;
  NonceSource nonces;
  KeyStore keys;
  ReplayMemory replays;
  Counters counters;
};

}  // namespace javinolib
