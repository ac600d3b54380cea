#pragma once

#include <stdint.h>

#include "../support/Flash.h"
#include "../support/Inlining.h"
#include "DeadBands.h"
#include "Reply.h"

namespace javinolib {

/// Collects the board's percepts while a sketch's percept callback runs. Each percept is an AgentSpeak literal. All
/// together fit one reply (some 500 bytes, each percept with 3 more). Percepts that do not fit are left out and
/// counted, and the agent is told.
class Percepts {
 public:
  Percepts(Reply &reply, DeadBands &deadBands) : reply_(reply), deadBands_(deadBands), leftOut_(0) {}

  // `name`
  void add(const FlashText *name) { literal(name); }

  // `name(number)`
  void add(const FlashText *name, int number) { add(name, static_cast<long>(number)); }
  void add(const FlashText *name, unsigned int number) { add(name, static_cast<unsigned long>(number)); }
  void add(const FlashText *name, long number);
  void add(const FlashText *name, unsigned long number);

  // `name(20.99)`, rounded to two decimals, of a number between -21 and 21 million. In place of another one, or of NAN as
  // of a sensor that does not answer, the host is told so, and the agent perceives nothing.
  void add(const FlashText *name, double number) { addHundredths(name, hundredths(number)); }

  // `name(number)` for a value that trembles: the number told last stays until the new one differs from it by the dead
  // band or more, and until it has been told for the least time (0 for none). The board does so for JAVINO_DEAD_BANDS
  // percepts (Config.h), and tells all further ones as they are. Each call needs an F("…") of its own.
  template <typename Number, typename Band>
  void add(const FlashText *name, Number number, Band deadBand, unsigned long leastMillis = 0) {
    const bool isInteger = static_cast<Number>(1) / 2 == 0;
    if (isInteger) {
      addSettled(name, static_cast<long>(number), static_cast<unsigned long>(deadBand), leastMillis);
    } else {
      addSettled(name, static_cast<double>(number), static_cast<double>(deadBand), leastMillis);
    }
  }

  // `name` for something that lasts for less than the time between two readings, such as the press of a button: if it
  // happens in any reading, it is told in the next one that the agent gets. It takes the place of a dead band. Each call
  // needs an F("…") of its own.
  void event(const FlashText *name, bool happens) {
    if (deadBands_.latch(name, happens)) add(name);
  }

  // `name(number)` of such an event, as the number of an RFID tag or of a key: a whole number of up to 32 bits. Another one,
  // before the agent has had the last, takes its place, which is counted.
  template <typename Number>
  void event(const FlashText *name, bool happens, Number number) {
    static_assert(static_cast<Number>(1) / 2 == 0, "the number of an event is a whole one");
    long told = static_cast<long>(number);
    if (deadBands_.latch(name, happens, told)) add(name, static_cast<Number>(told));
  }

  // `name("text")`, with quotes, backslashes and line feeds in the text escaped
  void add(const FlashText *name, const char *text) { write(name, Text(text)); }
  void add(const FlashText *name, const FlashText *text) { write(name, Text(text)); }
  template <typename String>
  auto add(const FlashText *name, const String &text) -> decltype(text.c_str(), void()) {
    add(name, text.c_str());
  }

  // A name without F("…") would lie in RAM: the compiler says what to write.
  template <typename... Rest>
  void add(const char *, Rest...) {
    static_assert(sizeof...(Rest) + 1 == 0, "write the name as in percepts.add(F(\"light\"), 5)");
  }
  template <typename... Rest>
  void event(const char *, Rest...) {
    static_assert(sizeof...(Rest) + 1 == 0, "write the name as in percepts.event(F(\"pressed\"), happens)");
  }

  // A whole literal, written unchanged: `position(3,"km")`
  void literal(const char *text) { write(Text(text)); }
  void literal(const FlashText *text) { write(Text(text)); }
  template <typename String>
  auto literal(const String &text) -> decltype(text.c_str(), void()) {
    literal(text.c_str());
  }

  /// How many percepts did not fit.
  uint16_t leftOut() const { return leftOut_; }

 private:
  // In place of hundredths: of what is beyond the range, of what is infinite, and of what is no number.
  static const long BEYOND = 2147483645;
  static const long INFINITE = BEYOND + 1;
  static const long NONE = BEYOND + 2;

  // A number's hundredths, or one of these.
  JAVINO_NOINLINE static long hundredths(double number);
  JAVINO_NOINLINE void addSettled(const FlashText *name, long number, unsigned long deadBand,
                                  unsigned long leastMillis) {
    add(name, deadBands_.settle(name, number, deadBand, leastMillis));
  }
  JAVINO_NOINLINE void addSettled(const FlashText *name, double number, double deadBand, unsigned long leastMillis);
  JAVINO_NOINLINE void addHundredths(const FlashText *name, long number);

  // A text in RAM or in flash.
  struct Text {
    explicit Text(const char *text) : at(text), inFlash(false) {}
    explicit Text(const FlashText *text) : at(reinterpret_cast<const char *>(text)), inFlash(true) {}
    char operator[](uint16_t index) const;

    const char *at;
    bool inFlash;
  };

  JAVINO_NOINLINE void write(const Text &literal);
  JAVINO_NOINLINE void write(const FlashText *name, const Text &text);
  JAVINO_NOINLINE void write(const FlashText *name, bool negative, unsigned long magnitude);
  void close(Record &record);

  Reply &reply_;
  DeadBands &deadBands_;
  uint16_t leftOut_;
};

}  // namespace javinolib
