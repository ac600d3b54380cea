#pragma once

#include <stdint.h>

#include "../delivery/Inbox.h"
#include "../delivery/Outcomes.h"
#include "../delivery/Overheard.h"
#include "../support/Inlining.h"
#include "../support/Counters.h"
#include "DeadBands.h"
#include "Percepts.h"
#include "Reply.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// A sketch's function that says what the board perceives now.
typedef void (*PerceptSource)(Percepts &percepts);

/// Answers a poll, and holds the answer until there is something to tell: outcomes of transmissions, received messages,
/// frames without a key, packets that were overheard, or percepts that have changed (SPEC 4.3).
class Poll {
 public:
  /// How often the sensors are read, where the sketch does not say it.
  static const uint8_t DEFAULT_SAMPLE_MILLIS = 20;

  Poll(Outcomes &outcomes, Inbox &inbox, Overheard &overheard, Counters &counters)
      : outcomes_(outcomes),
        inbox_(inbox),
        overheard_(overheard),
        counters_(counters),
        sampleMillis_(DEFAULT_SAMPLE_MILLIS) {}

  void setSource(PerceptSource source) { source_ = source; }

  /// While a poll is held, the source is called this often at most, at least 1 ms.
  void sampleEvery(uint16_t millis) { sampleMillis_ = millis; }

  /// The host has taken over the message of this number and all before it.
  void taken(uint8_t number) { inbox_.taken(number); }

  /// The host may not have had the last reply: what that told is told again.
  void tellAgain();

  /// Begins a poll, which is held until answer() has written its reply.
  /// @param flags those of the request
  /// @param holdMillis how long it may be held
  /// @param leastMillis the least time from one reading told to the next one
  /// @return false, and nothing is done, where these are not the flags of a request
  bool hold(uint8_t flags, uint16_t holdMillis, uint32_t leastMillis);

  /// Writes the body of the reply to the poll that is held, if it is to be sent now.
  /// @param released whether the host has something else to ask, so that the poll may not be held any longer
  /// @return whether it wrote it; true where no poll is held
  bool answer(Reply &reply, bool released);

  /// Whether a poll is held to which answer() has a message or an outcome to tell. Safe to call with interrupts off.
  bool canTell() const { return held_ && isWaiting(); }

 private:
  bool isWaiting() const;
  JAVINO_NOINLINE void addWaiting(Reply &reply);
  void addOutcomes(Reply &reply);
  bool addMessages(Reply &reply);
  bool addNoKeys(Reply &reply);
  bool addOverheard(Reply &reply);
  static bool addMessage(uint8_t number, const Inbox::Message &message, Reply &reply);
  bool isOver(uint32_t now) const { return static_cast<int32_t>(now - endsAt_) >= 0; }
  bool isReadingDue(uint32_t now, bool released) const;
  JAVINO_NOINLINE bool addReading(uint32_t now, Reply &reply);

  Outcomes &outcomes_;
  Inbox &inbox_;
  Overheard &overheard_;
  Counters &counters_;
  PerceptSource source_ JAVINO_ZEROED;
  uint16_t sampleMillis_;
  uint32_t sampledAt_ JAVINO_ZEROED;
  bool held_ JAVINO_ZEROED;
  bool told_ JAVINO_ZEROED;  // the host knows a reading
  uint32_t toldAt_;          // these two of the last one
  uint32_t toldHash_;
  uint8_t flags_;  // these three of the poll that is held
  uint32_t endsAt_;
  uint32_t leastMillis_;
  DeadBands deadBands_;  // last: AVR reaches only the first 64 bytes of an object in one instruction
};

}  // namespace javinolib
