#pragma once

#include <stdint.h>

#include "../framing/Address.h"
#include "../support/Counters.h"
#include "../support/Inlining.h"
#include "../support/Part.h"
#include "../support/Zeroed.h"
#include "Actions.h"
#include "Poll.h"
#include "Reply.h"
#include "Request.h"

namespace javinolib {

/// A board's reply to hello, but for its name (SPEC 4.3).
struct Identity {
  uint8_t version;
  uint8_t id[Address::TEXT_LENGTH];  ///< `++++` where none is set
  uint8_t bootEpoch[3];              ///< 0 where none is kept
  uint8_t capabilities;              ///< of Capability::Bit
};

struct Capability {
  enum Bit : uint8_t {
#define CAPABILITY(name, bit, title, meaning) name = bit,
#include "../support/Capabilities.def"
#undef CAPABILITY
  };
};

/// Performs the requests that every board knows: hello, poll, actions, counters (SPEC 4.3).
class Commands {
 public:
  /// @param firmwareName UTF-8; what exceeds 100 bytes is not told
  Commands(const char *firmwareName, Actions &actions, Poll &poll, SerialCounters &counters)
      : firmwareName_(firmwareName), actions_(actions), poll_(poll), counters_(counters) {}

  /// Performs a request and writes status and body of its reply, which stands at an OK without a body. The body of a
  /// poll's reply is left to answer().
  /// @return whether the reply is to be remembered for repeats of the request
  JAVINO_NOINLINE bool perform(const Request &request, Reply &reply);

  /// Writes the body of the reply to the poll that is held, if it is to be sent now (Poll::answer).
  bool answer(Reply &reply, bool released) { return poll_->answer(reply, released); }

  /// Whether answer() has something to tell that does not only depend on time. Safe to call with interrupts off.
  bool canTell() const { return false; }

  /// Whether a request may be performed; if not, the reply says why.
  bool allows(const Request &request, Reply &reply) const;

  /// Looks at a request to the board itself.
  /// @return OK, WRONG_ORIGIN or UNKNOWN_COMMAND
  static Status check(const Request &request);

  /// Performs a request to any board itself, which check() found to be OK.
  /// @return UNKNOWN_COMMAND for those that differ from board to board, hello and statistics too
  Status command(const Request &request, Reply &reply);

  /// Performs a hello.
  Status hello(const Request &request, const Identity &identity, Reply &reply);

  /// Appends a counter to the reply of statistics.
  JAVINO_NOINLINE static void addCounter(uint8_t number, config::Count value, Reply &reply);

 private:
  Status act(const uint8_t *body, Length length, Reply &reply);
  Status poll(const uint8_t *body, Length length);
  Status statistics(Length length, Reply &reply) const;

  const char *const firmwareName_;
  Part<Actions> actions_;
  Part<Poll> poll_;
  Part<SerialCounters> counters_;
  bool greeted_ JAVINO_ZEROED;
};

}  // namespace javinolib
