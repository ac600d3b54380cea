#pragma once

#include "../storage/BootEpoch.h"
#include "../storage/KeyStore.h"
#include "../storage/RfId.h"
#include "../support/Counters.h"
#include "../support/Inlining.h"
#include "../support/Part.h"
#include "../support/Random.h"
#include "NonceSource.h"
#include "ReplayMemory.h"

namespace javinolib {

/// The state that many parts of a board need: who it is, its keys and nonces, random numbers and counters.
///
/// Each part has one reference to all of it: with one to each that it needs, a board took 40 bytes more of RAM and 250 of
/// flash on an AVR.
struct BoardState {
  BoardState() : nonces(epoch), replays(keys) {}

  void count(Counter counter) { counters->count(counter); }

  RfId id;
  OwnPart<Random> random;
  BootEpoch epoch;
  NonceSource nonces;
  KeyStore keys;
  ReplayMemory replays;
  OwnPart<Counters> counters;
};

#ifdef __AVR__
template <>
inline KeyStore &Part<KeyStore>::the() {
  return Part<BoardState>::the().keys;
}
template <>
inline const KeyStore &Part<const KeyStore>::the() {
  return Part<BoardState>::the().keys;
}
template <>
inline BootEpoch &Part<BootEpoch>::the() {
  return Part<BoardState>::the().epoch;
}
template <>
inline NonceSource &Part<NonceSource>::the() {
  return Part<BoardState>::the().nonces;
}
template <>
inline ReplayMemory &Part<ReplayMemory>::the() {
  return Part<BoardState>::the().replays;
}
#endif

}  // namespace javinolib
