#pragma once

#include <board/Board.h>
#include <radioboard/RadioBoard.h>

#include <memory>
#include <vector>

#include "Bytes.h"
#include "FakeClock.h"
#include "FakePort.h"
#include "FakeRadio.h"
#include "SimulatedEeprom.h"
#include "SimulatedRam.h"

/// Flags of a poll.
const uint8_t NO_PERCEPTS = 0;
const uint8_t PERCEPTS = 1;
const uint8_t PERCEPTS_NOW = 3;
const uint8_t REPLY_LOST = 4;
const uint8_t REPLY_COMING = 8;

/// How message 0 has ended, as a poll tells it.
const std::string DELIVERED("\0\1", 2);
const std::string UNDELIVERED("\0\2", 2);

/// A record of a poll reply.
struct PollRecord {
  char type;
  Bytes value;
};

struct PollReply {
  bool more = false;
  bool leftOut = false;
  bool reading = false;
  std::vector<PollRecord> records;

  /// The values of all records of a type, as text.
  std::vector<std::string> texts(char type) const;
};

/// A message as a poll brings it.
struct PolledMessage {
  explicit PolledMessage(const Bytes &value);

  uint8_t number;
  std::string destination;
  std::string origin;
  Bytes id;
  std::string content;
};

/// A reply as it came: status and body.
struct BoardReply {
  javinolib::Status status;
  Bytes body;
};

/// A host on a fake port that talks to a board by the definition in SPEC 4, and the board's clock.
class TestHost {
 public:
  BoardReply hello();

  /// Sends a message to the board itself under a new sequence byte, and takes its reply; a poll that is held for it is
  /// released at once.
  BoardReply request(const Bytes &message);
  BoardReply request(char command, const Bytes &body = Bytes()) { return request(Bytes(1, command) + body); }

  /// Asks for a content to be transmitted.
  BoardReply transmit(const std::string &destination, const std::string &origin, const std::string &content);

  /// Polls without a hold. A reading is told only if nothing else waits, but then even if nothing has changed.
  PollReply poll(bool percepts = false);
  PollReply pollTaking(uint8_t taken);

  /// Begins a poll that the board may hold.
  void hold(uint8_t flags, uint16_t holdMillis, uint32_t leastMillis = 0);

  /// Whether the board has replied to this poll.
  bool replies() const;

  /// Takes its reply; throws where there is none.
  PollReply takeReply();

  uint32_t counter(javinolib::Counter counter);

  /// Sends any frame as a request; throws where not exactly one good reply comes.
  BoardReply exchange(const Bytes &frame);

  /// Sends bytes as they are; @return what comes between zeros, but for empty packets.
  std::vector<Bytes> sendRaw(const Bytes &bytes);

  /// Lets time pass, and the board run in each millisecond.
  void pass(uint32_t millis);

  FakePort port;
  FakeClock clock;

 protected:
  virtual ~TestHost() = default;
  virtual void run() = 0;

 private:
  Bytes packet(const Bytes &frame);
  std::vector<Bytes> takePackets();

  uint8_t sequence_ = 0;
};

/// A board without a radio.
class PlainBoard : public TestHost {
 public:
  PlainBoard() { reboot(); }

  void reboot() {
    clock.millis = 0;
    port = FakePort();
    board.reset(new javinolib::Board(javinolib::SerialPort(port), "plain 1.0"));
    board->begin();
  }

  std::unique_ptr<javinolib::Board> board;

 protected:
  void run() override { board->run(); }
};

/// A board with a fake radio and EEPROM. The EEPROM and the RAM that a reset leaves alone outlive reboots.
class TestBoard : public TestHost {
 public:
  /// @param other the board's radio, which outlives it, instead of the fake one
  explicit TestBoard(javinolib::Radio *other = nullptr) : other_(other) { reboot(); }

  /// Makes this board's hardware the chip's: for tests with several boards, before each use of one.
  void use();

  /// Resets the board, which starts again; what is on its way on port and radio is lost.
  /// @return what begin() returned
  bool reboot();

  /// Loses power, and starts again.
  bool powerUp();

  /// Reboots, says hello, sets an RF id where one is given, opens the radio, and waits for long quiet.
  void start(const std::string &rfId = "");

  BoardReply setKey(const std::string &address, const Bytes &key) { return request('K', bytesOf(address) + key); }

  std::vector<PolledMessage> messages();

  /// Lets a packet arrive by radio.
  void receive(const Bytes &payload);

  /// Lets the packet on the air end, and the board see it.
  void finishSending();

  /// Lets time pass, and each packet of the board end within a millisecond.
  void passSending(uint32_t millis);

  /// Lets time pass until the board sends; throws where it does not within 2 s.
  /// @return the packet
  const Bytes &nextSent();

  /// Lets time pass until the board sends and then until the packet's end.
  Bytes sendNext();

  FakeRadio radio;
  SimulatedEeprom eeprom;
  SimulatedRam ram;
  std::unique_ptr<javinolib::RadioBoard> board;
  bool unicastsOnly = false;  ///< from the next boot on, its sketch makes a JavinoUnicastBoard

 protected:
  void run() override { unicastsOnly ? board->run<javinolib::UnicastScope>() : board->run(); }

 private:
  javinolib::Radio *const other_;
};

/// Makes what another board would send: a sealed frame, as it is on the air.
Bytes sealed(const Bytes &key, const std::string &destination, const std::string &origin, const Bytes &nonce,
             const std::string &content);

/// A plain frame.
Bytes plain(const std::string &destination, const std::string &origin, const std::string &content);
