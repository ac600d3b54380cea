#pragma once

#include "../board/Board.h"
#include "../radioboard/RadioBoard.h"
#include "../storage/Eeprom.h"
#include "../storage/EepromLayout.h"
#include "../support/Core.h"
#include "CoresEeprom.h"
#include "Cpu.h"
#include "OtherPort.h"

namespace javinolib {

/// An Arduino that an agent can reach: the one object that a sketch needs, a global or static one (support/Zeroed.h).
template <typename Board>
class ArduinoBoard {
 public:
  static void *operator new(size_t) = delete;

  // Sets the function that adds the board's percepts. While an agent wants percepts, it is called every 20 ms, and the
  // agent is told what it adds whenever that has changed.
  void onPercepts(PerceptSource source) { board_.poll().setSource(source); }

  // Sets another time for these 20 ms, 1…65535 ms.
  void sampleEvery(uint16_t millis) { board_.poll().sampleEvery(millis); }

  // Names an action. Call it in setup(), as an agent asks for the names only when it connects. Returns false if the
  // name is taken or empty, or if there are JAVINO_ACTIONS (Config.h) already.
  bool action(const FlashText *name, Action action) { return board_.actions().add(name, action); }

  // Names an action that returns a number.
  bool action(const FlashText *name, ResultAction action) { return board_.actions().addResult(name, action); }

  template <typename Function>
  bool action(const char *, Function) {
    static_assert(sizeof(Function) == 0, "write the name as in board.action(F(\"ledOn\"), ledOn)");
    return false;
  }

  // Has all actions performed by another than those with a name.
  void performBy(Actions::Performer performer) { board_.actions().performBy(performer); }

  // Does all work that is due.
  void serve() {
    board_.run();
    commit(board_);
  }

  // Whether an agent waits for percepts.
  bool wantsPercepts() const { return board_.poll().wantsPercepts(); }

  // Opens the serial line, 8N1, and starts the radio if there is one; call it once, at the end of setup().
  // Returns false if the radio does not start or the EEPROM cannot be written; all else works nevertheless.
  bool begin(unsigned long baud) {
    port_.begin(baud);
    const bool works = board_.begin();
    commit(board_);
    return works;
  }

  // Does all work that is due, then lets the CPU idle until the next interrupt, which comes within 1 ms (the timer of
  // millis()); on other chips than AVR it calls yield(). Call it from loop(), and at least every 5 ms while requests may come: the UART holds 64 bytes.
  void run() {
    serve();
    cpu::holdInterrupts();
    if (board_.isIdle()) {
      cpu::releaseInterruptsAndIdle();
    } else {
      cpu::releaseInterrupts();
    }
  }

 protected:
  template <typename... Parts>
  explicit ArduinoBoard(SerialPort port, Parts &&...parts) : port_(port), board_(port, parts...) {}

 private:
  static void commit(const javinolib::Board &) {}
  static void commit(const RadioBoard &) { eeprom::commit(); }

  SerialPort port_;
  Board board_;
};

}  // namespace javinolib

/// A board with percepts and actions.
class JavinoBoard : public javinolib::ArduinoBoard<javinolib::Board> {
 public:
  // The host is at Serial or another port, as Serial1. The name tells it which sketch this is; it is a plain "lamp 1.0", as F("…")
  // is not possible outside of functions.
  template <typename Port>
  JavinoBoard(Port &port, const char *firmwareName) : ArduinoBoard(javinolib::hostPort(port), firmwareName) {}
};

namespace javinolib {

/// An Arduino with a radio.
template <typename Board>
class ArduinoRadioBoard : public ArduinoBoard<Board> {
 public:
  // The radio outlives it.
  template <typename Port>
  ArduinoRadioBoard(Port &port, const char *firmwareName, Radio &radio)
      : ArduinoBoard<Board>(hostPort(port), firmwareName, radio) {
    static_assert(EEPROM_SUFFICES || sizeof(Port) == 0,
                  "this chip's EEPROM has no room for keys: 4096 bytes, or with JAVINO_SMALL 1024");
#ifndef __AVR__
    eeprom::use(coresEeprom<Port>());
#endif
  }

  // One whose keys are in another memory than the core's `EEPROM`, which outlives the board. An AVR needs none.
  template <typename Port>
  ArduinoRadioBoard(Port &port, const char *firmwareName, Radio &radio, Eeprom &memory)
      : ArduinoBoard<Board>(hostPort(port), firmwareName, radio) {
#ifdef __AVR__
    static_assert(sizeof(Port) == 0, "an AVR has its own EEPROM for keys: leave out the board's fourth argument");
    (void)memory;
#else
    eeprom::use(memory);
#endif
  }
};

}  // namespace javinolib

/// A board with percepts, actions and a radio.
class JavinoRadioBoard : public javinolib::ArduinoRadioBoard<javinolib::RadioBoard> {
  using ArduinoRadioBoard::ArduinoRadioBoard;
};

/// One that takes less of the flash: its radio has sealed unicasts, but no groups, no broadcasts and no renewal of
/// keys.
class JavinoUnicastBoard : public javinolib::ArduinoRadioBoard<javinolib::UnicastBoard> {
  using ArduinoRadioBoard::ArduinoRadioBoard;
};
