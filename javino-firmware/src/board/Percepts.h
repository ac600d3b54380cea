#pragma once

#include <stdint.h>

#include "../support/Flash.h"
#include "../support/Inlining.h"
#include "../support/Counters.h"
#include "Reply.h"

namespace javino {

/// Collects the board's percepts while a sketch's percept callback runs. Each percept is an AgentSpeak literal. All
/// together fit one reply (some 500 bytes, each percept with 3 more). Percepts that do not fit are left out and
/// counted, and the agent is told.
class Percepts {
 public:
  Percepts(Reply &reply, Counters &counters) : reply_(reply), counters_(counters), leftOut_(false) {}

  // `name`
  void add(const FlashText *name) { literal(name); }

  // `name(number)`
  void add(const FlashText *name, int number) { add(name, static_cast<long>(number)); }
  void add(const FlashText *name, unsigned int number) { add(name, static_cast<unsigned long>(number)); }
  void add(const FlashText *name, long number);
  void add(const FlashText *name, unsigned long number);

  // `name("text")`, with quotes, backslashes and line feeds in the text escaped
  void add(const FlashText *name, const char *text) { write(name, Text(text)); }
  void add(const FlashText *name, const FlashText *text) { write(name, Text(text)); }

  // A whole literal, written unchanged: `position(3,"km")`
  void literal(const char *text) { write(Text(text)); }
  void literal(const FlashText *text) { write(Text(text)); }

  /// Whether some percepts did not fit.
  bool leftOut() const { return leftOut_; }

 private:
  // A text in RAM or in flash.
  struct Text {
    explicit Text(const char *text) : at(text), inFlash(false) {}
    explicit Text(const FlashText *text) : at(reinterpret_cast<const char *>(text)), inFlash(true) {}
    char operator[](uint16_t index) const;

    const char *at;
    bool inFlash;
  };

  static void open(Record &record, const FlashText *name);
  JAVINO_NOINLINE void write(const Text &literal);
  JAVINO_NOINLINE void write(const FlashText *name, const Text &text);
  JAVINO_NOINLINE void write(const FlashText *name, bool negative, unsigned long magnitude);
  void close(Record &record);

  Reply &reply_;
  Counters &counters_;
  bool leftOut_;
};

}  // namespace javino
