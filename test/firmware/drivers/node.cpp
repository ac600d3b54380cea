// A board of RadioHead's simulator, whose radio is JavinoRadioHead over RH_TCP: node server:port number id|relay bit/s. It does what the
// lines at its standard input say, and tells what happens.
#define Serial SimulatorsSerial  // the tests have others
#define millis simulatorsMillis
#include <RH_TCP.h>
#include <RHutil/simulator.h>
#undef Serial
#undef millis
#include <delivery/Relay.h>
#include <fcntl.h>
#include <unistd.h>

#include <iostream>
#include <sstream>

#include "JavinoRadioHead.h"
#include "support/Keys.h"
#include "support/TestBoard.h"

namespace {

/// RadioHead 1.112 leaves out a packet's last byte in its simulator, which its own examples, as strings, do not need.
class WholeTcp : public RH_TCP {
 public:
  using RH_TCP::RH_TCP;

  bool send(const uint8_t *payload, uint8_t length) override {
    const Bytes more = Bytes(payload, payload + length) + Bytes{0};
    return RH_TCP::send(more.data(), static_cast<uint8_t>(more.size()));
  }
};

const std::string ROMA("ROMA"), SUPO("SUPO");

std::unique_ptr<TestBoard> board;
javinolib::Relay *relay = nullptr;
std::unique_ptr<FakeClock> relaysClock;
uint32_t passed = 0;

void say(const std::string &line) { std::cout << line << std::endl; }

void obey() {
  static std::string line;
  char next;
  while (read(STDIN_FILENO, &next, 1) == 1) {
    if (next != '\n') {
      line += next;
      continue;
    }
    const size_t blank = line.find(' ');
    board->transmit(line.substr(0, blank), ROMA, line.substr(blank + 1));
    line.clear();
  }
}

void tell() {
  for (const PollRecord &record : board->poll().records) {
    if (record.type == 'T') say(record.value[1] == 1 ? "delivered" : record.value[1] == 0 ? "sent" : "undelivered");
    if (record.type != 'M') continue;
    const PolledMessage message(record.value);
    say(message.origin + " to " + message.destination + ": " + message.content);
    board->pollTaking(message.number);
  }
}

}  // namespace

void setup() {
  fcntl(STDIN_FILENO, F_SETFL, O_NONBLOCK);
  static WholeTcp tcp(_simulator_argv[1]);
  if (!tcp.init()) exit(1);
  tcp.setMode(RHGenericDriver::RHModeIdle);  // which it never tells
  tcp.setThisAddress(static_cast<uint8_t>(atoi(_simulator_argv[2])));
  static JavinoRadioHead radio(tcp, JavinoAirRate::fsk(static_cast<uint32_t>(atol(_simulator_argv[4]))));
  const std::string id = _simulator_argv[3];
  if (id == "relay") {
    relaysClock.reset(new FakeClock);
    static javinolib::Relay itself(radio);
    relay = &itself;
    say(relay->begin() ? "ready" : "the radio does not start");
    return;
  }
  board.reset(new TestBoard(&radio));
  board->start(id);
  board->setKey(id == ROMA ? SUPO : ROMA, KEY);
  say("ready");
}

// The board's clock follows the computer's, but not over a time in which this process did not run.
void loop() {
  static unsigned long before = simulatorsMillis();
  const unsigned long now = simulatorsMillis();
  const unsigned long left = std::min(now - before, 20ul);
  before = now;
  for (unsigned long millis = 0; millis < left; millis++, passed++) {
    if (relay) {
      relaysClock->millis++;
      relay->run();
    } else {
      board->pass(1);
      if (passed % 20 == 0) {
        obey();
        tell();
      }
    }
  }
  usleep(300);
}
