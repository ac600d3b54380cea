#pragma once

#include <stdint.h>

namespace javinolib {

/// The rule of retries of one message (SPEC 7.2 and 7.3): how often it is tried, what an attempt asks, how long its answer is
/// awaited, and how many others may go before it.
class Retries {
 public:
  /// How often the patience begins anew while a relay carries a message: 3 s in all.
  static const uint8_t ROUNDS_WITH_RELAY = 19;

  /// Begins with a new message.
  void begin() { passed_ = 0; }

  /// Begins with a frame that nobody has seen yet.
  void restart() { attempts_ = 0; }

  /// Attempts in a row that came to nothing; of a broadcast or multicast, how often it was sent.
  uint8_t attempts() const { return attempts_; }

  /// An attempt came to nothing new.
  /// @return whether it was the last one
  bool failed();

  /// A broadcast or multicast was sent. One that is relayed is sent once: if it asks for an answer, its sender asks again.
  /// @return whether it was the last time
  bool sent(bool isMulticast, bool isRelayed);

  /// The receiver has told of a fragment that it was not known to have.
  void progressed() { attempts_ = 0; }

  /// A relay carries the attempt before on: the one that waits for the air is none.
  void carriedOn() { attempts_--; }

  /// The next attempt sends one fragment, which asks which fragments have arrived:
  /// 1. The first one: without it the receiver can answer none.
  /// 2. If the receiver is known to have the first one, every other attempt sends the one again that asked last, since that is
  ///    likely what it lacks.
  /// @param arrived a bit for each fragment that the receiver is known to have
  /// @param asked the bit of the fragment that asked last
  /// @return the fragment's bit
  uint8_t next(uint8_t arrived, uint8_t asked) const;

  /// How often the patience begins anew for an attempt's answer: 600 ms in all where a relay may carry the message.
  uint8_t rounds(bool isWhole) const;

  /// Whether no new message may go before this one.
  bool isFirst() const;

  /// A new message goes before this one.
  void letPass() { passed_++; }

 private:
  uint8_t attempts_;
  uint8_t passed_;
};

/// How long an answer is awaited, in quiet air: other boards' packets do not use it up.
class Patience {
 public:
  /// @param rounds how often it begins anew
  void begin(uint8_t rounds);

  /// Counts on; to be asked each time the medium was looked at, with the quiet time since, in ms.
  bool isOver(uint8_t quietMillis);

  /// How often it still begins anew.
  uint8_t rounds() const { return rounds_; }

 private:
  uint8_t millis_;
  uint8_t rounds_;
};

}  // namespace javinolib
