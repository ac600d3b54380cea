#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../support/Counters.h"
#include "../support/Flash.h"
#include "../support/Inlining.h"
#include "../support/Part.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// The values last told of percepts that have a dead band or a least interval of their own, and events that are still to be
/// told. A percept is known by the place of its name in flash; among percepts of one name in a reading, by their order.
class DeadBands {
 public:
  /// @param counters count events whose number the host has not had when another one takes its place
  explicit DeadBands(SerialCounters &counters) : counters_(counters) {}

  /// To be called before each reading. A percept that the last reading lacked is forgotten.
  /// @param anew all others too, but events: the host knows no reading, or asks for the values as they are
  void begin(bool anew);

  /// The value to tell of a percept: the one last told, until the new one differs from it by the dead band or more, and it has
  /// been told for the least time. A percept that is new, or for which no place is left, is told as it is.
  long settle(const FlashText *name, long number, unsigned long deadBand, unsigned long leastMillis);

  /// Whether to tell of an event, which happens now or has happened since it was told last.
  JAVINO_NOINLINE bool latch(const FlashText *name, bool happens);

  /// The same of an event with a number, which is kept for as long as the event is to be told; another number is another event.
  /// @param number that of what happens now; then the one to tell
  bool latch(const FlashText *name, bool happens, long &number);

  /// The reading goes to the host.
  void told() { move(READING_TOLD); }

  /// The host's word about the last reading: it has not had it, it has, or it may still come. Then it has had the one before.
  void confirm(bool lost, bool coming) { move(lost ? READING_LOST : coming ? READING_COMING : READING_HAD); }

  /// Whether there are events, which may happen between two readings that may be told.
  bool haveEvents() const { return mover_ != nullptr; }

 private:
  enum Event : uint8_t {
    NO_EVENT,
    IDLE,
    OVER,       // the host still believes it, until the next reading that goes to it
    AGAIN,      // so it does, but it has happened once more: it is told behind that reading
    GONE,       // as OVER, but the reply that told it may still come
    GONE_TOLD,  // so it may, and that it is over was told behind it
    WAITING,    // from here on it is in the reading
    TOLD,
    MAY_COME,  // told in the reading before the last one
    KNOWN      // the host has had it
  };

  enum Cause : uint8_t { READING_TOLD, READING_LOST, READING_COMING, READING_HAD };

  struct Entry {
    const FlashText *name;  // null where the place is free
    Event event;
    bool seen;  // in the reading under way
    long told;  // or an event's number
    uint32_t changedAt;
  };

  Entry *find(const FlashText *name);
  void move(Cause cause) {
    if (mover_ != nullptr) mover_(*this, cause);
  }
  static void moveEvents(DeadBands &bands, Cause cause);

  Part<SerialCounters> counters_;
  // Null until there is an event: a sketch without any has no code for them.
  void (*mover_)(DeadBands &bands, Cause cause) JAVINO_ZEROED;
  Entry entries_[config::DEAD_BANDS] JAVINO_ZEROED;
};

}  // namespace javinolib
