// Boards over serial modules: messages arrive, are acknowledged, and are sent again only if one was lost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <serialradio/SerialRadio.h>

#include "support/FakeUart.h"
#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::SerialModule;
using javinolib::Status;
using testing::ElementsAre;

namespace {

struct Module {
  std::string name;
  const SerialModule *module;
  size_t payload;
};

void PrintTo(const Module &module, std::ostream *out) { *out << module.name; }

// As the README has one: of the fewest bytes.
const SerialModule MINE = {19200, javinolib::MIN_RADIO_PAYLOAD, 30, 30, 1500};

// A board and its module, which gives on what it got when nothing came for 20 ms.
struct Side {
  explicit Side(const SerialModule &module) : radio(uart, module), board(&radio) {}

  FakeUart uart;
  javinolib::SerialRadio radio;
  TestBoard board;
  Bytes given;         // to the module, and not yet on the air
  uint32_t since = 0;  // the last byte came
};

class SerialRadioDelivery : public testing::TestWithParam<Module> {
 protected:
  SerialRadioDelivery() : roma(*GetParam().module), supo(*GetParam().module) {
    roma.board.start("ROMA");
    supo.board.start("SUPO");
    supo.board.setKey("ROMA", KEY);
    roma.board.use();
    roma.board.setKey("SUPO", KEY);
  }

  void pass(uint32_t millis) {
    for (; millis != 0; millis--) {
      passIn(roma, supo);
      passIn(supo, roma);
    }
  }

  // A byte goes out each millisecond, and four come.
  void passIn(Side &from, Side &to) {
    from.board.use();
    from.board.pass(1);
    const Bytes byte = from.uart.take(1);
    from.given = from.given + byte;
    if (!byte.empty()) from.since = 0;
    if (++from.since < 20 || from.given.empty()) return;
    if (lost != 0) {
      lost--;
      from.given.clear();
    }
    const size_t next = std::min<size_t>(4, from.given.size());
    to.uart.arrive(Bytes(from.given.begin(), from.given.begin() + next));
    from.given.erase(from.given.begin(), from.given.begin() + next);
  }

  // The messages that SUPO's host gets, which polls every 20 ms.
  std::vector<std::string> received() {
    std::vector<std::string> received;
    for (int polls = 0; polls < 500 && received.empty(); polls++) {
      pass(20);
      received = contents();
    }
    return received;
  }

  std::vector<std::string> contents() {
    supo.board.use();
    std::vector<std::string> contents;
    for (const PolledMessage &message : supo.board.messages()) {
      contents.push_back(message.content);
      supo.board.pollTaking(message.number);
    }
    return contents;
  }

  Status send(const std::string &content) {
    roma.board.use();
    return roma.board.transmit("SUPO", "ROMA", content).status;
  }

  uint32_t resent() {
    roma.board.use();
    return roma.board.counter(Counter::RADIO_RESENT);
  }

  std::vector<std::string> outcomes() {
    roma.board.use();
    return roma.board.poll().texts('T');
  }

  int lost = 0;  // so many packets are
  Side roma, supo;
};

}  // namespace

TEST_P(SerialRadioDelivery, delivers_at_the_first_attempt) {
  ASSERT_EQ(Status::OK, send("tell;help"));
  EXPECT_THAT(received(), ElementsAre("tell;help"));
  pass(2000);
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  EXPECT_EQ(0u, resent());
}

TEST_P(SerialRadioDelivery, delivers_a_message_in_fragments) {
  ASSERT_EQ(Status::OK, send(std::string(GetParam().payload - 10, 'x')));
  EXPECT_THAT(received(), ElementsAre(std::string(GetParam().payload - 10, 'x')));
  pass(2000);
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  EXPECT_EQ(0u, resent());
}

TEST_P(SerialRadioDelivery, sends_again_what_was_lost) {
  lost = 1;
  ASSERT_EQ(Status::OK, send("tell;help"));
  EXPECT_THAT(received(), ElementsAre("tell;help"));
  pass(2000);
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  EXPECT_EQ(1u, resent());
}

INSTANTIATE_TEST_SUITE_P(, SerialRadioDelivery,
                         testing::Values(Module{"HC_12", &JAVINO_HC_12, 77}, Module{"E32", &JAVINO_E32, 52},
                                         Module{"E22", &JAVINO_E22, 77}, Module{"MINE", &MINE, 26}),
                         [](const testing::TestParamInfo<Module> &module) { return module.param.name; });
