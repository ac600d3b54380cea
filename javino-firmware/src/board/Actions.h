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
  /// @return false, and nothing changes, where name or function is missing, the name is taken or the table is full.
  bool add(const FlashText *name, Action action);

  /// Performs what a request asks for.
  /// @return OK, BAD_ARGUMENT, UNKNOWN_ACTION or ACTION_FAILED
  JAVINO_NOINLINE Status perform(const uint8_t *action, uint16_t length) const;

  /// Tells how many there are, and of their names, one after the other and each with its closing 0x00, what fits from an
  /// offset on.
  /// @return OK or BAD_ARGUMENT
  Status list(const uint8_t *offset, uint16_t length, Reply &reply) const;

 private:
  struct Entry {
    const FlashText *name;
    Action action;
  };

  Action find(const char *name, uint16_t length) const;

  uint8_t count_ JAVINO_ZEROED;
  Entry entries_[config::ACTIONS == 0 ? 1 : config::ACTIONS];
};

}  // namespace javinolib
