#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "../support/Counters.h"
#include "DeadBands.h"
#include "Percepts.h"
#include "Reply.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// A sketch's function that says what the board perceives now.
typedef void (*PerceptSource)(Percepts &percepts);

/// Answers a poll, and holds the answer until percepts have changed (SPEC 4.3).
class Poll {
 public:
  /// How often the sensors are read, where the sketch does not say it.
  static const uint8_t DEFAULT_SAMPLE_MILLIS = 20;

  enum RequestFlag : uint8_t { PERCEPTS_WANTED = 1, READING_NOW = 2, REPLY_LOST = 4, REPLY_COMING = 8 };
  enum ReplyFlag : uint8_t { MORE_WAITING = 1, PERCEPTS_OMITTED = 2, HAS_READING = 4, MEMORY_DAMAGED = 8 };

  explicit Poll(SerialCounters &counters)
      : counters_(counters), sampleMillis_(DEFAULT_SAMPLE_MILLIS), deadBands_(counters) {}

  void setSource(PerceptSource source) { source_ = source; }

  /// While a poll is held, the source is called this often at most, at least 1 ms.
  void sampleEvery(uint16_t millis) { sampleMillis_ = millis; }

  /// The host may not have had the last reading.
  void tellAgain() {
    told_ = false;
    deadBands_.confirm(true, false);
  }

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

  /// Whether a poll is held that wants percepts.
  bool wantsPercepts() const { return held_ && (flags_ & PERCEPTS_WANTED) != 0; }

  /// Whether a poll is held. Safe to call with interrupts off.
  bool isHeld() const { return held_; }

  /// Its reply is written: it is held no longer.
  void end() { held_ = false; }

 private:
  bool isOver(uint32_t now) const { return static_cast<int32_t>(now - endsAt_) >= 0; }
  JAVINO_OUT_OF_LINE bool mayTell(uint32_t now) const { return now - toldAt_ >= leastMillis_; }
  bool isReadingDue(uint32_t now, bool released) const;
  bool addReading(uint32_t now, Reply &reply);

  Part<SerialCounters> counters_;
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
