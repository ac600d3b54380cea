// Compiled for the ATmega2560, never run: a change of what fits it has to be made here too.

#include <avr/io.h>

#include <board/Board.h>
#include <radioboard/RadioBoard.h>
#include <storage/EepromLayout.h>
#include <storage/Retained.h>

namespace javinolib {

static_assert(config::LARGE, "");
static_assert(config::KEYS == 16, "");
static_assert(config::SESSION_KEYS == 8, "");
static_assert(config::REPLAY_ENTRIES == 24, "");
static_assert(config::FLOOR_SLOTS == 96, "");
static_assert(config::MAX_MESSAGE == 511, "");
static_assert(config::RECEIVE_BYTES == 640, "");
static_assert(config::TRANSMIT_BYTES == 640, "");
static_assert(config::PARTNERS == 4, "");
static_assert(config::MULTICAST_SENDS == 2, "");
static_assert(config::BROADCAST_SENDS == 1, "");
static_assert(config::RECENT_BROADCASTS == 8, "");
static_assert(config::OVERHEARD_BYTES == 168, "");
static_assert(config::RADIO_PACKETS == 2, "");
static_assert(config::ACKNOWLEDGEMENTS == 6, "");
static_assert(config::ACTIONS == 16, "");
static_assert(config::DEAD_BANDS == 8, "");
static_assert(config::EPOCH_SLOTS == 16, "");

static_assert(RF_ID_AT == 737, "where it differs, a board that is flashed anew is to be provisioned anew");
static_assert(sizeof(TakenNonces) == 392, "retained RAM, beside the board's");

// The parts of a board lie beside it (support/Part.h).
const size_t PARTS = sizeof(Actions) + sizeof(Poll);
const size_t RADIO_PARTS = PARTS + sizeof(Commands) + sizeof(BoardState) + sizeof(Delivery) + sizeof(MediumAccess) +
                           sizeof(Acknowledger) + sizeof(Inbox) + sizeof(FrameAcceptor) + sizeof(Retransmitter) +
                           sizeof(CapturedPackets);
static_assert(sizeof(Board) + PARTS <= 800, "static RAM of a board without a radio");
static_assert(sizeof(RadioBoard) + RADIO_PARTS <= 4000, "and of one with a radio, beside the radio's");

}  // namespace javinolib
