#pragma once

#include "ArduinoBoard.h"

/// The interface of the published Javino 1.7 and of the first one, so that their sketches compile unchanged: a global
/// `Javino javino;`. It has one object, on `Serial`. What the library with radio (2.0) has beside is an error that says
/// what to write: there a sketch hands messages on and has their key, here the board does so for its agent.
class Javino {
 public:
  typedef void (*Function)();

  /// The functions of actions, by name: `javino.act["ledOn"] = ledOn;` with a name that lasts.
  class Actions {
   public:
    Function &operator[](const char *name);

   private:
    friend class Javino;

    Function find(const String &name) const;

    struct Entry {
      const char *name;
      Function function;
    };

    Entry entries_[javinolib::config::ACTIONS];
    uint8_t count_;
  };

  Javino();

  // Opens the line, at 115200 baud whatever is asked: hosts begin with that.
  void start(unsigned long);

  // Sets the function that calls addPercept().
  void perceive(Function function) { perceive_ = function; }

  // Adds literals, with semicolons between them, to the next reading.
  void addPercept(const String &literals) { percepts_ += literals + ';'; }

  // Does all work that is due. Call it from loop().
  void run() { readSerial(); }

  Actions act;

  // The parts of run(), for a sketch that does without it.

  // Reads and answers what the line brings.
  void readSerial();

  // Whether an agent wants percepts that no function adds, or an action, if `act` has none. What it wants is told once.
  // Opens the line if start() has not: sketches for the first Javino call Serial.begin() themselves.
  bool availableMsg();

  // The last message: of an action its whole text, as it came.
  bool requestPercepts() const;
  bool requestAction(const String &action) const { return message_ == action; }
  String getMsg() const { return message_; }

  // The percepts that were added are the board's from now on.
  void sendPercepts();
  void clearPercepts() { percepts_ = String(); }

  // The literals, with semicolons between them, are the board's percepts from now on (SPEC 4.6).
  void sendMsg(const String &literals) { reading_ = literals; }

  // The same in the words of the first Javino.
  bool availablemsg() { return availableMsg(); }
  String getmsg() const { return getMsg(); }
  void sendmsg(const String &literals) { sendMsg(literals); }

  // Without the radio, a name that nobody asks for.
  void setId(const String &) {}
  void setAlias(const String &) {}

  template <typename Pin>
  void enableRF(Pin, Pin) {
    static_assert(sizeof(Pin) == 0,
                  "for the radio write JavinoAskRadio radio; JavinoRadioBoard board(Serial, \"bus 1.0\", radio); "
                  "instead of Javino");
  }

  template <typename Key>
  void setCipherKey(Key) {
    static_assert(sizeof(Key) == 0, "leave the key out: javino provision puts keys on boards");
  }

  template <typename Text, typename... Texts>
  void sendMsgRF(Text, Texts...) {
    static_assert(sizeof(Text) == 0,
                  "leave messages to the agent, .diffuse(\"ROMA\", tell, help), or write JavinoBroadcaster");
  }

  template <typename Nothing = char>
  bool availableMsgRF() {
    static_assert(sizeof(Nothing) == 0, "leave messages to the agent: .getRFMessages(open)");
    return false;
  }

  template <typename Nothing = char>
  void buffer2USB() {
    static_assert(sizeof(Nothing) == 0, "leave messages to the agent: .getRFMessages(open)");
  }

 private:
  class Board : public javinolib::ArduinoBoard<javinolib::Board> {
   public:
    Board() : ArduinoBoard(javinolib::SerialPort(Serial), "Javino 1.7") {}
  };

  static void perceive(javinolib::Percepts &percepts);
  static javinolib::Status perform(javinolib::Part<javinolib::Actions>, const uint8_t *action, javinolib::Length length,
                                   javinolib::Reply &);

  Board board_;
  Function perceive_;
  String percepts_;  // each with a semicolon
  String reading_;   // those that hold
  String wanted_;    // an action that availableMsg() has not told of
  String message_;
  unsigned long askedAt_;
  bool isOpen_;
};
