#pragma once

#include <Arduino.h>

#include "../board/Board.h"

namespace javinolib {

/// The type of `Serial`: a UART, or USB on chips that have it (ATmega32U4).
typedef decltype(Serial) HostSerial;

/// An Arduino that an agent can reach: the one object that a sketch needs, a global or static one (support/Zeroed.h).
class Javino {
 public:
  static void *operator new(size_t) = delete;

  // A board with the ASK radio on its default pins. The name tells the host which sketch this is; it is a plain
  // "vehicle 1.0", as F("…") is not possible outside of functions.
  Javino(HostSerial &serial, const char *firmwareName);

  // A board with the ASK radio on other pins, or with any other radio.
  Javino(HostSerial &serial, const char *firmwareName, Radio &radio);

  // Sets the function that adds the board's percepts. While an agent wants percepts, it is called every 20 ms, and the
  // agent is told what it adds whenever that has changed.
  void onPercepts(PerceptSource source) { board_.onPercepts(source); }

  // Sets another time for these 20 ms, 1…65535 ms.
  void sampleEvery(uint16_t millis) { board_.sampleEvery(millis); }

  // Names an action. Call it in setup(), as an agent asks for the names only when it connects. Returns false if the
  // name is taken or empty, or if there are JAVINO_ACTIONS (Config.h) already.
  bool action(const FlashText *name, Action action) { return board_.action(name, action); }

  // Opens the serial line, 8N1, and starts the radio; call it once, at the end of setup().
  // Returns false if the radio does not start or the EEPROM cannot be written; all else works nevertheless.
  bool begin(unsigned long baud);

  // Does all work that is due, then lets the CPU idle until the next interrupt, which comes within 1 ms (the timer of
  // millis()). Call it from loop(), and at least every 5 ms while requests may come: the UART holds 64 bytes.
  void run();

 private:
  HostSerial &serial_;
  Board board_;
};

}  // namespace javinolib
