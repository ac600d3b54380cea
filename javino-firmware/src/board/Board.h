#pragma once

#include "../support/Counters.h"
#include "../support/Part.h"
#include "Actions.h"
#include "Commands.h"
#include "Poll.h"
#include "SerialPort.h"
#include "SerialSession.h"

namespace javinolib {

/// A whole board without its hardware that has percepts and actions, but no radio: what the protocol asks of it, behind the
/// seams serial port and clock. The class JavinoBoard puts it on an Arduino.
class Board {
 public:
  /// The UART and the name outlive the board.
  Board(SerialPort port, const char *firmwareName)
      : actions_(counters_),
        poll_(counters_),
        commands_(firmwareName, actions_, poll_, counters_),
        session_(port, packet_, sizeof packet_, counters_) {}

  /// To be called once, after a boot. Nothing can fail here.
  bool begin() {
    session_.askAgain();
    session_.ran();
    return true;
  }

  /// Handles what the serial line brought. Never waits.
  void run() {
    session_.run(commands_);
    session_.ran();
  }

  /// Whether run() has nothing to do until the next interrupt. Safe to call with interrupts off.
  bool isIdle() const { return session_.isIdle(); }

  Poll &poll() { return poll_; }
  const Poll &poll() const { return *poll_.operator->(); }
  Actions &actions() { return actions_; }

 private:
  OwnPart<SerialCounters> counters_;
  OwnPart<Actions> actions_;
  OwnPart<Poll> poll_;
  Commands commands_;
  SerialSession session_;
  uint8_t packet_[PACKET_OVERHEAD + config::BOARD_MESSAGE];
};

}  // namespace javinolib
