// Compiled for the ATmega328P, never run: a change of what fits it has to be made here too.

#include <avr/io.h>

#include <board/Board.h>
#include <radioboard/RadioBoard.h>
#include <storage/EepromLayout.h>
#include <storage/Retained.h>

namespace javinolib {

static_assert(!config::LARGE, "");
static_assert(config::KEYS == 6, "");
static_assert(config::SESSION_KEYS == 0, "");
static_assert(config::REPLAY_ENTRIES == 6, "");
static_assert(config::FLOOR_SLOTS == 18, "");
static_assert(config::MAX_MESSAGE == 84, "");
static_assert(config::RECEIVE_BYTES == 92, "");
static_assert(config::TRANSMIT_BYTES == 97, "");
static_assert(config::PARTNERS == 1, "");
static_assert(config::MULTICAST_SENDS == 2, "");
static_assert(config::BROADCAST_SENDS == 1, "");
static_assert(config::RECENT_BROADCASTS == 3, "");
static_assert(config::OVERHEARD_BYTES == 0, "");
static_assert(config::RADIO_PACKETS == 2, "");
static_assert(config::ACKNOWLEDGEMENTS == 3, "");
static_assert(config::ACTIONS == 8, "");
static_assert(config::DEAD_BANDS == 2, "");
static_assert(config::EPOCH_SLOTS == 16, "");

static_assert(MAX_CONTENT_LENGTH == 67, "a broadcast of one packet");
static_assert(RF_ID_AT == 138, "where it differs, a board that is flashed anew is to be provisioned anew");
static_assert(sizeof(TakenNonces) == 80, "retained RAM, beside the board's");

// The parts of a board lie beside it (support/Part.h).
const size_t PARTS = sizeof(Actions) + sizeof(Poll);
const size_t RADIO_PARTS = PARTS + sizeof(Commands) + sizeof(BoardState) + sizeof(Delivery) + sizeof(MediumAccess) +
                           sizeof(Acknowledger) + sizeof(Inbox) + sizeof(FrameAcceptor) + sizeof(Retransmitter) +
                           sizeof(CapturedPackets);
static_assert(sizeof(Board) + PARTS <= 420, "static RAM of a board without a radio");
static_assert(sizeof(RadioBoard) + RADIO_PARTS <= 710, "and of one with a radio, beside the radio's");

}  // namespace javinolib
