#include "RadioBoard.h"

namespace javinolib {

RadioBoard::RadioBoard(SerialPort port, const char *firmwareName, Radio &radio)
    : delivery_(radio, state_),
      actions_(state_->counters->serial()),
      poll_(state_->counters->serial()),
      commands_(firmwareName, actions_, poll_, state_->counters->serial()),
      radioCommands_(commands_, state_, delivery_, poll_),
      session_(port, packet_, sizeof packet_, state_->counters->serial()) {}

template <typename Scope>
bool RadioBoard::begin() {
  state_->id.begin();
  state_->epoch.begin(state_->keys.begin<Scope>());
  if (!state_->replays.begin(state_->epoch.value())) state_->count(Counter::MEMORY_DAMAGED);
  if (state_->epoch.status() == Status::EPOCH_LOST) state_->replays.doubtFloors<Scope>();
  const bool radioStarted = delivery_->begin();
  session_.askAgain();
  session_.ran();
  return radioStarted && state_->epoch.status() != Status::STORE_FAILED;
}

template <typename Scope>
class CommandsOf {
 public:
  explicit CommandsOf(RadioCommands &commands) : commands_(commands) {}

  bool perform(const Request &request, Reply &reply) { return commands_->perform<Scope>(request, reply); }
  bool answer(Reply &reply, bool released) { return commands_->answer(reply, released); }

 private:
  Part<RadioCommands> commands_;
};

// The host first: what it asks for is then sent before the CPU sleeps. What the air brings to a poll that is held keeps the
// CPU awake for another round.
template <typename Scope>
void RadioBoard::run() {
  CommandsOf<Scope> commands(radioCommands_);
  session_.run(commands);
  delivery_->run<Scope>();
  session_.ran();
}

template bool RadioBoard::begin<WholeScope>();
template bool RadioBoard::begin<UnicastScope>();
template void RadioBoard::run<WholeScope>();
template void RadioBoard::run<UnicastScope>();

}  // namespace javinolib
