// Compiled for the ATmega2560, never run: a change of what fits it has to be made here too.

#include <avr/io.h>

#include <board/Board.h>
#include <storage/EepromLayout.h>

namespace javino {

static_assert(config::KEYS == 16, "");
static_assert(config::REPLAY_ENTRIES == 24, "");
static_assert(config::RECEIVE_QUEUE == 4, "");
static_assert(config::TRANSMIT_QUEUE == 2, "");
static_assert(config::ACTIONS == 16, "");
static_assert(config::EPOCH_SLOTS == 16, "");
static_assert(config::EEPROM_START == 0, "");

static_assert(EEPROM_END == 725, "");
static_assert(sizeof(Board) <= 2252, "the protocol's part of static RAM, 2.2 KiB");

}  // namespace javino
