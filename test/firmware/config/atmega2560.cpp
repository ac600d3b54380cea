// Compiled for the ATmega2560, never run: a change of what fits it has to be made here too.

#include <avr/io.h>

#include <board/Board.h>
#include <storage/EepromLayout.h>
#include <storage/Retained.h>

namespace javinolib {

static_assert(config::KEYS == 16, "");
static_assert(config::SESSION_KEYS == 8, "");
static_assert(config::REPLAY_ENTRIES == 24, "");
static_assert(config::FLOOR_SLOTS == 96, "");
static_assert(config::MAX_MESSAGE == 511, "");
static_assert(config::RECEIVE_BYTES == 640, "");
static_assert(config::TRANSMIT_BYTES == 640, "");
static_assert(config::PARTNERS == 4, "");
static_assert(config::REASSEMBLIES == 2, "");
static_assert(config::MULTICAST_SENDS == 2, "");
static_assert(config::BROADCAST_SENDS == 1, "");
static_assert(config::BROADCAST_ORIGINS == 4, "");
static_assert(config::OVERHEARD_BYTES == 256, "");
static_assert(config::RADIO_PACKETS == 3, "");
static_assert(config::ACKNOWLEDGEMENTS == 6, "");
static_assert(config::ACTIONS == 16, "");
static_assert(config::DEAD_BANDS == 8, "");
static_assert(config::PARITY, "");
static_assert(config::EPOCH_SLOTS == 16, "");
static_assert(config::EEPROM_START == 0, "");

static_assert(EEPROM_END == 3359, "");
static_assert(sizeof(TakenNonces) == 424, "retained RAM, beside the board's");
static_assert(sizeof(Board) <= 5113, "the protocol's part of static RAM");

}  // namespace javinolib
