#pragma once

#include <Arduino.h>

#include "../board/Board.h"

namespace javino {

/// What `Serial` is: a UART, or on chips with USB of their own (ATmega32U4) that.
typedef decltype(Serial) HostSerial;

/// An Arduino that an agent can reach: the one object that a sketch needs.
class Javino {
 public:
  // With the ASK radio on its default pins. The name is told to the host and says which sketch this is: a plain
  // "vehicle 1.0", as F("…") cannot stand outside of functions.
  Javino(HostSerial &serial, const char *firmwareName);

  // With the ASK radio on other pins, or any other radio.
  Javino(HostSerial &serial, const char *firmwareName, Radio &radio);

  // Names the function that says what the board perceives; it is called for each poll that asks for percepts.
  void onPercepts(PerceptSource source) { board_.onPercepts(source); }

  // Names an action; call it in setup(), as an agent asks for the names when it comes, and not again. Returns false
  // where the name is taken or empty, or Config.h's number of actions is reached.
  bool action(const FlashText *name, Action action) { return board_.action(name, action); }

  // Opens the serial line, 8N1, and starts the radio; call it once, at the end of setup().
  // Returns false where the radio could not be started or the EEPROM not be written; all else works nevertheless.
  bool begin(unsigned long baud);

  // Does what there is to do, then lets the CPU idle until the next interrupt, which is at most 1 ms away (the timer
  // of millis()). Call it from loop(), and at least every 5 ms while requests may come: the UART holds 64 bytes.
  void run();

 private:
  HostSerial &serial_;
  Board board_;
};

}  // namespace javino
