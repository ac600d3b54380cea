#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Address.h"
#include "../framing/Limits.h"

namespace javino {

/// What ReplayMemory knows of one origin under one key.
struct TakenNonce {
  Address origin;
  uint8_t key;    ///< place of the key in the key store
  uint8_t state;  ///< of ReplayMemory
  uint8_t floor;  ///< place of the floor in its ring
  uint8_t nonce[NONCE_LENGTH];
};

/// All of it, as it stays in RAM over a reset.
struct TakenNonces {
  uint32_t epoch;  ///< the boot that it belongs to
  TakenNonce entries[config::REPLAY_ENTRIES + config::SESSION_KEYS];
  uint16_t check;  ///< CRC of all before
};

/// RAM that a reset leaves alone, but a loss of power does not: whoever uses it has to find out what it is worth. The
/// seam is bound when linking, to ArduinoSeams.cpp on a board and to SimulatedRam in the host tests.
namespace retained {

TakenNonces &takenNonces();

}  // namespace retained
}  // namespace javino
