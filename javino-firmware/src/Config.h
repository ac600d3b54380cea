#pragma once

#include <stdint.h>

/// How much the board remembers, in one place. Each value can be set with -D on the compiler's command line; the
/// defaults fit an ATmega2560 (8 KiB of RAM, 4 KiB of EEPROM). What each costs in RAM stands beside it.

/// Keys in the EEPROM store, previous ones included, 1…63 (one reply lists them all). 4 bytes of RAM and 42 of EEPROM
/// each, and for one place more, which a new key is written to before an old one goes.
#ifndef JAVINO_KEYS
#define JAVINO_KEYS 16
#endif

/// Origins, counted once for each key, whose last nonce is remembered, 1…253. 13 bytes of RAM each.
#ifndef JAVINO_REPLAY_ENTRIES
#define JAVINO_REPLAY_ENTRIES 24
#endif

/// Places of the ring that holds the floors of these nonces, more than the entries by one or more, at most 254. 12 bytes
/// of EEPROM each. The more of them are free, the longer the EEPROM lasts: see ReplayMemory.h.
#ifndef JAVINO_FLOOR_SLOTS
#define JAVINO_FLOOR_SLOTS 96
#endif

/// Received messages that wait for the host, 1…128. 76 bytes of RAM each.
#ifndef JAVINO_RECEIVE_QUEUE
#define JAVINO_RECEIVE_QUEUE 4
#endif

/// Packets that wait for the air, 1…16. 78 bytes of RAM each.
#ifndef JAVINO_TRANSMIT_QUEUE
#define JAVINO_TRANSMIT_QUEUE 2
#endif

/// Actions that a sketch can name, 1…254. 4 bytes of RAM each.
#ifndef JAVINO_ACTIONS
#define JAVINO_ACTIONS 16
#endif

/// Places of the ring that holds the boot epoch, 4…64. 5 bytes of EEPROM each; each is good for 25 000 boots.
#ifndef JAVINO_EPOCH_SLOTS
#define JAVINO_EPOCH_SLOTS 16
#endif

/// The first byte of EEPROM that Javino uses; the README tells the layout.
#ifndef JAVINO_EEPROM_START
#define JAVINO_EEPROM_START 0
#endif

namespace javino {
namespace config {

static const uint8_t KEYS = JAVINO_KEYS;
static const uint8_t REPLAY_ENTRIES = JAVINO_REPLAY_ENTRIES;
static const uint8_t FLOOR_SLOTS = JAVINO_FLOOR_SLOTS;
static const uint8_t RECEIVE_QUEUE = JAVINO_RECEIVE_QUEUE;
static const uint8_t TRANSMIT_QUEUE = JAVINO_TRANSMIT_QUEUE;
static const uint8_t ACTIONS = JAVINO_ACTIONS;
static const uint8_t EPOCH_SLOTS = JAVINO_EPOCH_SLOTS;
static const uint16_t EEPROM_START = JAVINO_EEPROM_START;

static_assert(JAVINO_KEYS >= 1 && JAVINO_KEYS <= 63, "JAVINO_KEYS must be 1…63: one reply lists all keys");
static_assert(JAVINO_REPLAY_ENTRIES >= 1 && JAVINO_REPLAY_ENTRIES <= 253, "JAVINO_REPLAY_ENTRIES must be 1…253");
static_assert(JAVINO_FLOOR_SLOTS > JAVINO_REPLAY_ENTRIES && JAVINO_FLOOR_SLOTS <= 254,
              "JAVINO_FLOOR_SLOTS must be greater than JAVINO_REPLAY_ENTRIES, and at most 254");
static_assert(JAVINO_RECEIVE_QUEUE >= 1 && JAVINO_RECEIVE_QUEUE <= 128, "JAVINO_RECEIVE_QUEUE must be 1…128");
static_assert(JAVINO_TRANSMIT_QUEUE >= 1 && JAVINO_TRANSMIT_QUEUE <= 16, "JAVINO_TRANSMIT_QUEUE must be 1…16");
static_assert(JAVINO_ACTIONS >= 1 && JAVINO_ACTIONS <= 254, "JAVINO_ACTIONS must be 1…254");
static_assert(JAVINO_EPOCH_SLOTS >= 4 && JAVINO_EPOCH_SLOTS <= 64, "JAVINO_EPOCH_SLOTS must be 4…64");

}  // namespace config
}  // namespace javino
