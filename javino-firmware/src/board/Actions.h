#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../support/Flash.h"
#include "../support/Inlining.h"
#include "Arguments.h"
#include "Reply.h"
#include "../support/Status.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// A sketch's function for an action.
/// @return false where it refuses the action or its arguments; the agent's plan then fails.
typedef bool (*Action)(const Arguments &arguments);

/// The actions that a sketch has named.
class Actions {
 public:
  /// Performs what a request asks for, of which it gets the bytes as they came, in UTF-8.
  /// @return OK, BAD_ARGUMENT, UNKNOWN_ACTION or ACTION_FAILED
  typedef Status (*Performer)(const Actions &actions, const uint8_t *action, Length length);

  /// @return false, and nothing changes, where name or function is missing, the name is taken or the table is full.
  bool add(const FlashText *name, Action action);

  /// Has all performed by another than those that have a name here.
  void performBy(Performer performer) { performer_ = performer; }

  /// Performs what a request asks for (Performer).
  Status perform(const uint8_t *action, Length length) const {
    return performer_ == nullptr ? Status::UNKNOWN_ACTION : performer_(*this, action, length);
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

  static Status performNamed(const Actions &actions, const uint8_t *action, Length length);
  Action find(const char *name, Length length) const;

  // Null until there is an action: a sketch without any has no code for them.
  Performer performer_ JAVINO_ZEROED;
  uint8_t count_ JAVINO_ZEROED;
  Entry entries_[config::ACTIONS];
};

}  // namespace javinolib
