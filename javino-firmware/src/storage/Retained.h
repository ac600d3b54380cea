#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Address.h"
#include "../framing/Limits.h"
#include "../support/Inlining.h"

namespace javinolib {

/// The nonce of one origin under one key.
struct OriginNonce {
  uint8_t key;  ///< place of the key in the key store
  Address origin;
  uint8_t nonce[NONCE_LENGTH];
};

/// The knowledge of one origin under one key.
struct TakenNonce {
  OriginNonce taken;
  uint8_t state;  ///< of ReplayMemory
  uint8_t floor;  ///< place of the floor in its ring
};

/// All of it, as it stays in RAM over a reset. A check value and a canary guard it: the stack grows down to where this ends,
/// so what is too deep runs over the canary before all else.
struct TakenNonces {
  uint32_t epoch;  ///< the boot that it belongs to
  TakenNonce entries[config::REPLAY_ENTRIES + config::SESSION_KEYS];
  uint16_t check;  ///< CRC of all before
  uint16_t canary;
};

/// RAM that a reset leaves alone, but a loss of power does not: whoever uses it has to find out what it is worth.
namespace retained {

/// The seam is these three, bound when linking, to ArduinoSeams.cpp on a board and to SimulatedRam in the host tests.
TakenNonces &takenNonces();

/// The airtime that is left (AirtimeLimit), with a check of its own.
struct Airtime {
  uint32_t level;
  uint32_t check;
};

Airtime &airtime();

/// Whether the stack ends well above it, so that it can be written without harm to the stack; false for good once it did not.
bool isClear();

/// Whether nothing has run over it from above.
bool hasCanary();

/// Whether all is as seal() left it, and the stack is clear of it: 15 000 cycles on an ATmega2560.
JAVINO_NOINLINE bool holds();

/// To be called after each change, which is made only while it holds.
JAVINO_NOINLINE void seal();

/// Goes on in an epoch.
JAVINO_NOINLINE void beginEpoch(uint32_t epoch);

}  // namespace retained
}  // namespace javinolib
