#include "Result.h"

#include <string.h>

#include "../support/BigEndian.h"
#include "Actions.h"

// Actions that return numbers: a sketch without any has nothing of this file.

namespace javinolib {

namespace {

const uint8_t BITS = 8;

// A bit for each place of a board's actions whose function is a ResultAction. A program has one board.
uint8_t returning[(config::ACTIONS + BITS - 1) / BITS];

// Compilers warn of a cast of a function to one with other arguments, but not of one to this.
typedef void (*Function)();

}  // namespace

bool Actions::addResult(const FlashText *name, ResultAction action) {
  if (!add(name, reinterpret_cast<Action>(reinterpret_cast<Function>(action)))) return false;
  if (performer_ != performResult) memset(returning, 0, sizeof returning);
  performer_ = performResult;
  const uint8_t place = static_cast<uint8_t>(count_ - 1);
  returning[place / BITS] = static_cast<uint8_t>(returning[place / BITS] | 1 << place % BITS);
  return true;
}

// The reply takes the place of the request, whose arguments are read until the function has returned.
Status Actions::performResult(Part<Actions> actions, const uint8_t *text, Length length, Reply &reply) {
  Arguments arguments;
  if (!arguments.parse(text, length)) return Status::BAD_ARGUMENT;
  const Entry *const found = actions->find(arguments);
  if (found == nullptr) return Status::UNKNOWN_ACTION;
  const uint8_t place = static_cast<uint8_t>(found - actions->entries_);
  if ((returning[place / BITS] & 1 << place % BITS) == 0) {
    return found->action(arguments) ? Status::OK : Status::ACTION_FAILED;
  }
  const ResultAction action = reinterpret_cast<ResultAction>(reinterpret_cast<Function>(found->action));
  Result result;
  if (!action(arguments, result)) return Status::ACTION_FAILED;
  if (result.state_ == Result::BEYOND) actions->counters_->count(Counter::PERCEPTS_LEFT_OUT);
  if (result.state_ == Result::NUMBER) {
    uint8_t number[3];
    writeUint24(number, static_cast<Uint24>(result.number_));
    reply.add(number, sizeof number);
  }
  return Status::OK;
}

}  // namespace javinolib
