// The example driver holds the seam Radio: messages get through a radio whose packets are shorter than those of ASK.
#include <ArduinoMock.h>
#include <11_OwnRadio/LoopbackRadio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;
using testing::ElementsAre;
using testing::NiceMock;

namespace {

const std::string ONE_PACKET(8, 'x');         // with header, nonce and tag 32 bytes
const std::string EIGHT_FRAGMENTS(152, 'y');  // with header, nonce and tag 176 bytes, 22 in each fragment

class LoopbackRadioTest : public testing::Test {
 protected:
  LoopbackRadioTest() : roma(&romaRadio), supo(&supoRadio) {
    ON_CALL(arduino, millis).WillByDefault([this] { return now; });
    romaRadio.join(supoRadio);
    start(roma, "ROMA");
    start(supo, "SUPO");
    roma.use();
    roma.setKey("SUPO", KEY);
    supo.use();
    supo.setKey("ROMA", KEY);
    pass(200);
  }

  static void start(TestBoard &board, const std::string &id) {
    ASSERT_TRUE(board.reboot());
    board.hello();
    board.request('I', bytesOf(id));
    board.request('R', {1});
  }

  void pass(uint32_t millis) {
    for (; millis != 0; millis--) {
      now++;
      for (TestBoard *board : {&roma, &supo}) {
        board->use();
        board->pass(1);
      }
    }
  }

  Status send(const std::string &to, const std::string &content) {
    roma.use();
    return roma.transmit(to, "ROMA", content).status;
  }

  // The messages that SUPO's host gets, and hands on.
  std::vector<std::string> contents() {
    supo.use();
    std::vector<std::string> contents;
    for (const PolledMessage &message : supo.messages()) {
      contents.push_back(message.content);
      supo.pollTaking(message.number);
    }
    return contents;
  }

  std::vector<std::string> outcomes() {
    roma.use();
    return roma.poll().texts('T');
  }

  NiceMock<ArduinoMock> arduino;
  unsigned long now = 0;
  LoopbackRadio romaRadio, supoRadio;
  TestBoard roma, supo;
};

}  // namespace

TEST_F(LoopbackRadioTest, delivers_what_fits_one_packet) {
  ASSERT_EQ(Status::OK, send("SUPO", ONE_PACKET));
  pass(50);
  EXPECT_THAT(contents(), ElementsAre(ONE_PACKET));
  pass(50);
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  roma.use();
  EXPECT_EQ(1u, roma.counter(Counter::RADIO_SENT));
}

TEST_F(LoopbackRadioTest, delivers_the_longest_message_in_eight_fragments) {
  ASSERT_EQ(Status::OK, send("SUPO", EIGHT_FRAGMENTS));
  pass(200);
  EXPECT_THAT(contents(), ElementsAre(EIGHT_FRAGMENTS));
  pass(50);
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  roma.use();
  EXPECT_EQ(8u, roma.counter(Counter::RADIO_SENT));
}

TEST_F(LoopbackRadioTest, sends_again_only_the_fragment_that_was_missed) {
  ASSERT_EQ(Status::OK, send("SUPO", EIGHT_FRAGMENTS));
  while (romaRadio.idle()) pass(1);
  while (romaRadio.sending()) pass(1);
  while (!romaRadio.sending()) pass(1);
  const uint8_t other[LoopbackRadio::LONGEST] = {};
  ASSERT_TRUE(supoRadio.send(other, sizeof other));
  std::vector<std::string> received;
  for (int millis = 0; millis < 400 && received.empty(); millis++) {
    pass(1);
    received = contents();
  }
  EXPECT_THAT(received, ElementsAre(EIGHT_FRAGMENTS));
  pass(50);
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  roma.use();
  EXPECT_EQ(9u, roma.counter(Counter::RADIO_SENT));
  EXPECT_EQ(1u, roma.counter(Counter::RADIO_RESENT));
}

TEST_F(LoopbackRadioTest, refuses_what_eight_fragments_do_not_carry) {
  EXPECT_EQ(Status::TOO_LONG, send("SUPO", EIGHT_FRAGMENTS + "y"));
  EXPECT_EQ(Status::OK, send("////", EIGHT_FRAGMENTS + "fourteen bytes"));
  EXPECT_EQ(Status::TOO_LONG, send("////", EIGHT_FRAGMENTS + "fourteen bytes!"));
}

TEST_F(LoopbackRadioTest, a_radio_that_is_not_joined_does_not_start) {
  LoopbackRadio alone;
  EXPECT_FALSE(alone.begin());
  TestBoard board(&alone);
  EXPECT_FALSE(board.reboot());
}
