// Compiled for the ATmega328P, never run: a change of what fits it has to be made here too.

#include <avr/io.h>

#include <board/Board.h>
#include <storage/EepromLayout.h>
#include <storage/Retained.h>

namespace javinolib {

static_assert(config::KEYS == 6, "");
static_assert(config::SESSION_KEYS == 0, "");
static_assert(config::REPLAY_ENTRIES == 6, "");
static_assert(config::FLOOR_SLOTS == 23, "");
static_assert(config::MAX_MESSAGE == 84, "");
static_assert(config::RECEIVE_BYTES == 92, "");
static_assert(config::TRANSMIT_BYTES == 97, "");
static_assert(config::PARTNERS == 1, "");
static_assert(config::REASSEMBLIES == 0, "");
static_assert(config::MULTICAST_SENDS == 2, "");
static_assert(config::BROADCAST_SENDS == 1, "");
static_assert(config::BROADCAST_ORIGINS == 2, "");
static_assert(config::OVERHEARD_BYTES == 0, "");
static_assert(config::RADIO_PACKETS == 2, "");
static_assert(config::ACKNOWLEDGEMENTS == 3, "");
static_assert(config::ACTIONS == 8, "");
static_assert(config::DEAD_BANDS == 2, "");
static_assert(!config::PARITY, "");
static_assert(config::EPOCH_SLOTS == 16, "");
static_assert(config::EEPROM_START == 0, "");

static_assert(MAX_CONTENT_LENGTH == 67, "a broadcast of one packet");
static_assert(EEPROM_END == 1016, "of 1024 bytes");
static_assert(sizeof(TakenNonces) == 86, "retained RAM, beside the board's");
static_assert(sizeof(Board) <= 944, "the protocol's part of static RAM");

}  // namespace javinolib
