#include "Board.h"

namespace javino {

Board::Board(SerialPort port, Radio &radio, const char *firmwareName)
    : radio_(radio),
      nonces_(epoch_),
      transmitter_(radio),
      receiver_(radio, id_, keys_, replays_, counters_),
      sender_(transmitter_, id_, keys_, nonces_),
      poll_(transmitter_, receiver_.queue(), counters_),
      keyCommands_(keys_, replays_),
      commands_(firmwareName, radio, id_, epoch_, keyCommands_, sender_, poll_, actions_, counters_),
      session_(port, commands_, counters_) {}

bool Board::begin() {
  id_.begin();
  epoch_.begin();
  keys_.begin();
  replays_.begin(epoch_.value(), keys_);
  const bool radioStarted = radio_.begin();
  return radioStarted && epoch_.isStored();
}

void Board::run() {
  radio_.update();
  receiver_.run();
  transmitter_.run();
  session_.run();
  transmitter_.run();
}

bool Board::isIdle() const { return radio_.idle() && transmitter_.isIdle() && session_.isIdle(); }

}  // namespace javino
