#pragma once

#include "../board/Actions.h"
#include "../board/Commands.h"
#include "../board/Poll.h"
#include "../board/SerialPort.h"
#include "../board/SerialSession.h"
#include "../delivery/Delivery.h"
#include "../radio/Radio.h"
#include "../secure/BoardState.h"
#include "../support/Part.h"
#include "RadioCommands.h"

namespace javinolib {

/// A whole board without its hardware that has percepts, actions, a radio and keys: what the protocol asks of it, behind the
/// seams serial port, EEPROM, radio, clock and retained RAM. The class JavinoRadioBoard puts it on an Arduino.
class RadioBoard {
 public:
  /// The UART, the radio and the name outlive the board.
  RadioBoard(SerialPort port, const char *firmwareName, Radio &radio);

  /// Reads the EEPROM, raises the boot epoch and starts the radio. To be called once, after a boot.
  /// @return false where the radio could not be started or the EEPROM not be written; all else works nevertheless.
  template <typename Scope = WholeScope>
  bool begin();

  /// Handles what serial line and radio brought. Never waits, but for the EEPROM where a command writes to it.
  template <typename Scope = WholeScope>
  void run();

  /// Whether run() has nothing to do until the next interrupt. Safe to call with interrupts off.
  bool isIdle() const { return delivery_->isIdle() && session_.isIdle() && !radioCommands_->canTell(); }

  Poll &poll() { return poll_; }
  Actions &actions() { return actions_; }

 private:
  OwnPart<BoardState> state_;
  OwnPart<Delivery> delivery_;
  OwnPart<Actions> actions_;
  OwnPart<Poll> poll_;
  OwnPart<Commands> commands_;
  OwnPart<RadioCommands> radioCommands_;
  SerialSession session_;
  uint8_t packet_[MAX_PACKET_LENGTH];
};

/// One with sealed unicasts only.
class UnicastBoard : public RadioBoard {
 public:
  using RadioBoard::RadioBoard;

  bool begin() { return RadioBoard::begin<UnicastScope>(); }
  void run() { RadioBoard::run<UnicastScope>(); }
};

}  // namespace javinolib
