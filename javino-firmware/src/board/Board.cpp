#include "Board.h"

namespace javino {

Board::Board(SerialPort port, Radio &radio, const char *firmwareName)
    : radio_(radio),
      replays_(keys_),
      nonces_(epoch_),
      delivery_(radio, id_, epoch_, keys_, replays_, nonces_, counters_),
      poll_(delivery_.outbox().outcomes(), delivery_.inbox(), counters_),
      keyCommands_(keys_, replays_, nonces_),
      commands_(firmwareName, radio, id_, keys_, nonces_, keyCommands_, delivery_, poll_, actions_, counters_),
      session_(port, commands_, counters_) {}

bool Board::begin() {
  id_.begin();
  epoch_.begin();
  keys_.begin();
  replays_.begin(epoch_.value());
  const bool radioStarted = radio_.begin();
  delivery_.begin();
  return radioStarted && epoch_.isStored();
}

// The host first: what it asks for is then sent before the CPU sleeps. A packet that comes in the very round of a poll
// waits for the next one.
void Board::run() {
  session_.run();
  delivery_.run();
}

bool Board::isIdle() const { return radio_.idle() && session_.isIdle(); }

}  // namespace javino
