#include "Board.h"

namespace javinolib {

Board::Board(SerialPort port, Radio &radio, const char *firmwareName)
    : delivery_(radio, state_),
      poll_(delivery_.outbox().outcomes(), delivery_.inbox(), delivery_.overheard(), state_.counters),
      commands_(firmwareName, state_, delivery_, poll_, actions_),
      session_(port, commands_, poll_, state_.counters) {}

bool Board::begin() {
  state_.id.begin();
  state_.epoch.begin(state_.keys.begin());
  if (!state_.replays.begin(state_.epoch.value())) state_.count(Counter::MEMORY_DAMAGED);
  if (state_.epoch.status() == Status::EPOCH_LOST) state_.replays.doubtFloors();
  const bool radioStarted = delivery_.begin();
  return radioStarted && state_.epoch.status() != Status::STORE_FAILED;
}

// The host first: what it asks for is then sent before the CPU sleeps. What the air brings to a poll that is held keeps the
// CPU awake for another round.
void Board::run() {
  session_.run();
  delivery_.run();
}

bool Board::isIdle() const { return delivery_.isIdle() && session_.isIdle(); }

}  // namespace javinolib
