#pragma once

#include "../delivery/Delivery.h"
#include "../radio/Radio.h"
#include "../secure/BoardState.h"
#include "../support/Inlining.h"
#include "Actions.h"
#include "Commands.h"
#include "Poll.h"
#include "SerialPort.h"
#include "SerialSession.h"

namespace javinolib {

/// A whole board without its hardware: what the protocol asks of it, behind the seams serial port, EEPROM, radio, clock
/// and retained RAM. The class Javino puts it on an Arduino.
class Board {
 public:
  /// The UART, the radio and the name outlive the board.
  Board(SerialPort port, Radio &radio, const char *firmwareName);

  /// Reads the EEPROM, raises the boot epoch and starts the radio. To be called once, after a boot.
  /// @return false where the radio could not be started or the EEPROM not be written; all else works nevertheless.
  bool begin();

  /// Handles what serial line and radio brought. Never waits, but for the EEPROM where a command writes to it.
  void run();

  /// Whether run() has nothing to do until the next interrupt. Safe to call with interrupts off.
  bool isIdle() const;

  void onPercepts(PerceptSource source) { poll_.setSource(source); }
  void sampleEvery(uint16_t millis) { poll_.sampleEvery(millis); }
  bool action(const FlashText *name, Action action) { return actions_.add(name, action); }

 private:
  BoardState state_;
  Delivery delivery_;
  Actions actions_;
  Poll poll_;
  Commands commands_;
  SerialSession session_;
};

}  // namespace javinolib
