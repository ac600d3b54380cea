#pragma once

#include <stdint.h>

#include "../delivery/Inbox.h"
#include "../delivery/Outcomes.h"
#include "../support/Inlining.h"
#include "../support/Counters.h"
#include "Percepts.h"
#include "Reply.h"

namespace javino {

/// A sketch's function that says what the board perceives now.
typedef void (*PerceptSource)(Percepts &percepts);

/// Answers a poll: outcomes of transmissions, percepts, received messages, in one reply (SPEC 4.3).
class Poll {
 public:
  Poll(Outcomes &outcomes, Inbox &inbox, Counters &counters)
      : outcomes_(outcomes), inbox_(inbox), counters_(counters), source_(nullptr) {}

  void setSource(PerceptSource source) { source_ = source; }

  /// The host has taken over the message of this number and all before it.
  void taken(uint8_t number) { inbox_.taken(number); }

  /// The host has had the last reply: what it told of transmissions is forgotten.
  void replyArrived() { outcomes_.forgetTold(); }

  /// A host begins anew, who may not have had the last reply: what it told of transmissions is told again.
  void hostArrived() { outcomes_.keepTold(); }

  /// Writes the reply's body.
  /// @param perceptsWanted bit 0 of the request's flags
  /// @param airActive whether something is being received or sent
  JAVINO_NOINLINE void answer(bool perceptsWanted, bool airActive, Reply &reply);

 private:
  static const uint8_t MORE_WAITING = 1;
  static const uint8_t PERCEPTS_LEFT_OUT = 2;
  static const uint8_t AIR_ACTIVE = 4;

  void addOutcomes(Reply &reply);
  bool addPercepts(Reply &reply);
  bool addMessages(Reply &reply);
  static bool addMessage(uint8_t number, const Inbox::Message &message, Reply &reply);

  Outcomes &outcomes_;
  Inbox &inbox_;
  Counters &counters_;
  PerceptSource source_;
};

}  // namespace javino
