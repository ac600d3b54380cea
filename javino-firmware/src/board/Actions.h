#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../support/Flash.h"
#include "../support/Inlining.h"
#include "../support/Counters.h"
#include "../support/Part.h"
#include "Arguments.h"
#include "Reply.h"
#include "Result.h"
#include "../support/Status.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// A sketch's function for an action.
/// @return false where it refuses the action or its arguments; the agent's plan then fails.
typedef bool (*Action)(const Arguments &arguments);

/// The same of an action that returns a number.
typedef bool (*ResultAction)(const Arguments &arguments, Result &result);

/// The actions that a sketch has named.
class Actions {
 public:
  /// Performs what a request asks for, of which it gets the bytes as they came, in UTF-8; what it adds to the reply takes their
  /// place.
  /// @return OK, BAD_ARGUMENT, UNKNOWN_ACTION or ACTION_FAILED
  typedef Status (*Performer)(Part<Actions> actions, const uint8_t *action, Length length, Reply &reply);

  /// @param counters count the numbers that are beyond 24 bits
  explicit Actions(SerialCounters &counters) : counters_(counters) {}

  /// @return false, and nothing changes, where name or function is missing, the name is taken or the table is full.
  bool add(const FlashText *name, Action action);

  /// The same of an action that returns a number.
  bool addResult(const FlashText *name, ResultAction action);

  /// Has all performed by another than those that have a name here.
  void performBy(Performer performer) { performer_ = performer; }

  /// Performs what a request asks for (Performer).
  Status perform(const uint8_t *action, Length length, Reply &reply) {
    return performer_ == nullptr ? Status::UNKNOWN_ACTION : performer_(*this, action, length, reply);
  }

  /// Tells how many there are, and of their names, one after the other and each with its closing 0x00, what fits from an
  /// offset on.
  /// @return OK or BAD_ARGUMENT
  Status list(const uint8_t *offset, Length length, Reply &reply) const;

 private:
  struct Entry {
    const FlashText *name;
    Action action;
  };

  static Status performNamed(Part<Actions> actions, const uint8_t *action, Length length, Reply &reply);
  static Status performResult(Part<Actions> actions, const uint8_t *action, Length length, Reply &reply);
  const Entry *find(const Arguments &wanted) const;

  Part<SerialCounters> counters_;
  // Null until there is an action: a sketch without any has no code for them.
  Performer performer_ JAVINO_ZEROED;
  uint8_t count_ JAVINO_ZEROED;
  Entry entries_[config::ACTIONS];
};

}  // namespace javinolib
