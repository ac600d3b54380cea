#include "RadioBoard.h"

namespace javinolib {

RadioBoard::RadioBoard(SerialPort port, const char *firmwareName, Radio &radio)
    : delivery_(radio, state_),
      poll_(state_->counters->serial()),
      commands_(firmwareName, actions_, poll_, state_->counters->serial()),
      radioCommands_(commands_, state_, delivery_, poll_),
      session_(port, packet_, sizeof packet_, state_->counters->serial()) {}

bool RadioBoard::begin() {
  state_->id.begin();
  state_->epoch.begin(state_->keys.begin());
  if (!state_->replays.begin(state_->epoch.value())) state_->count(Counter::MEMORY_DAMAGED);
  if (state_->epoch.status() == Status::EPOCH_LOST) state_->replays.doubtFloors();
  const bool radioStarted = delivery_->begin();
  session_.askAgain();
  session_.ran();
  return radioStarted && state_->epoch.status() != Status::STORE_FAILED;
}

// The host first: what it asks for is then sent before the CPU sleeps. What the air brings to a poll that is held keeps the
// CPU awake for another round.
void RadioBoard::run() {
  session_.run(radioCommands_);
  delivery_->run();
  session_.ran();
}

}  // namespace javinolib
