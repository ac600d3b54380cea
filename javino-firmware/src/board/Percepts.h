#pragma once

#include <stdint.h>

#include "../support/Flash.h"
#include "Counters.h"
#include "Record.h"
#include "Reply.h"

namespace javino {

/// Takes what the board perceives now, while a sketch's percept callback runs. Each percept is an AgentSpeak literal;
/// the whole fits one reply (some 500 bytes, 3 more for each percept). What does not fit is left out, counted, and
/// the agent told so.
class Percepts {
 public:
  Percepts(Reply &reply, Counters &counters) : reply_(reply), counters_(counters), leftOut_(false) {}

  // `name`
  void add(const FlashText *name);

  // `name(number)`
  void add(const FlashText *name, int number) { add(name, static_cast<long>(number)); }
  void add(const FlashText *name, unsigned int number) { add(name, static_cast<unsigned long>(number)); }
  void add(const FlashText *name, long number);
  void add(const FlashText *name, unsigned long number);

  // `name("text")`, with what needs it in the text escaped
  void add(const FlashText *name, const char *text);
  void add(const FlashText *name, const FlashText *text);

  // A whole literal, as it stands: `position(3,"km")`
  void literal(const char *literal);
  void literal(const FlashText *literal);

  /// Whether some did not fit.
  bool leftOut() const { return leftOut_; }

 private:
  void addNumber(const FlashText *name, bool negative, unsigned long magnitude);
  void close(Record &record);

  Reply &reply_;
  Counters &counters_;
  bool leftOut_;
};

}  // namespace javino
