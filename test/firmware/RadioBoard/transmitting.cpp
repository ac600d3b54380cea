#include <gtest/gtest.h>

#include <set>

#include "support/Keys.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

const std::string SENT("\0", 1);

class BoardTransmitting : public testing::Test {
 protected:
  BoardTransmitting() {
    board.start("SUPP");
    board.setKey("SUHO", KEY);
    board.setKey("//SU", KEY);
  }

  TestBoard board;
};

}  // namespace

TEST_F(BoardTransmitting, sends_a_broadcast_as_it_is_and_once) {
  EXPECT_EQ(Bytes{0}, board.transmit("////", "SUPP", "tell;help").body);
  EXPECT_EQ("////SUPPBItell;help", textOf(board.sendNext()));
  board.pass(2000);
  EXPECT_EQ(1u, board.radio.sent.size());
}

TEST_F(BoardTransmitting, sends_a_multicast_twice_byte_for_byte) {
  board.transmit("//SU", "SUPP", "tell;x");
  const Bytes frame = sealed(KEY, "//SU", "SUPP", {0, 0, 2, 0, 0, 0}, "tell;x");
  EXPECT_EQ(frame, board.sendNext());
  EXPECT_TRUE(board.poll().records.empty());
  EXPECT_EQ(frame, board.sendNext());
  EXPECT_EQ(std::vector<std::string>{SENT + SENT}, board.poll().texts('T'));
  board.pass(2000);
  EXPECT_EQ(2u, board.radio.sent.size());
  EXPECT_EQ(1u, board.counter(Counter::RADIO_RESENT));
}

TEST_F(BoardTransmitting, seals_each_message_with_the_boot_epoch_and_a_counter) {
  board.transmit("//SU", "SUPP", "tell;x");
  board.transmit("SUHO", "SUPP", "tell;x");
  board.sendNext();
  board.sendNext();
  EXPECT_EQ(sealed(KEY, "SUHO", "SUPP", {0, 0, 2, 0, 0, 1}, "tell;x"), board.sendNext());
}

TEST_F(BoardTransmitting, reports_each_outcome_once_and_in_order) {
  for (int i = 0; i < 3; i++) {
    EXPECT_EQ(Bytes{static_cast<uint8_t>(i)}, board.transmit("////", "SUPP", "tell;x").body);
  }
  board.nextSent();
  EXPECT_TRUE(board.poll().records.empty()) << "the first is still on the air";
  board.finishSending();
  board.sendNext();
  EXPECT_EQ((std::vector<std::string>{std::string("\0\0", 2), std::string("\1\0", 2)}), board.poll().texts('T'));
  EXPECT_TRUE(board.poll().records.empty());
  board.sendNext();
  EXPECT_EQ((std::vector<std::string>{std::string("\2\0", 2)}), board.poll().texts('T'));
  EXPECT_EQ(3u, board.counter(Counter::RADIO_SENT));
}

TEST_F(BoardTransmitting, tells_an_outcome_again_to_a_host_that_begins_anew) {
  const std::vector<std::string> outcomes{std::string("\0\0", 2)};
  board.transmit("////", "SUPP", "tell;x");
  board.sendNext();
  EXPECT_EQ(outcomes, board.poll().texts('T'));
  board.hello();
  board.request('R', {1});
  EXPECT_EQ(outcomes, board.poll().texts('T'));
  EXPECT_TRUE(board.poll().records.empty()) << "this poll says that the reply to the last one has come";
  board.hello();
  EXPECT_TRUE(board.poll().records.empty());
}

TEST_F(BoardTransmitting, a_host_that_never_polls_loses_no_outcome) {
  unsigned accepted = 0;
  while (board.transmit("////", "SUPP", "tell;x").status == Status::OK) {
    accepted++;
    board.sendNext();
  }
  EXPECT_EQ(javinolib::Outcomes::MAX_UNREPORTED, accepted);
  EXPECT_EQ(accepted, board.poll().texts('T').size());
  EXPECT_EQ(Status::QUEUE_FULL, board.transmit("////", "SUPP", "tell;x").status) << "that reply may be lost";
  board.poll();
  EXPECT_EQ(Status::OK, board.transmit("////", "SUPP", "tell;x").status);
}

TEST_F(BoardTransmitting, transmission_numbers_run_around_after_255) {
  for (int i = 0; i < 600; i++) {
    ASSERT_EQ(Bytes{static_cast<uint8_t>(i)}, board.transmit("////", "SUPP", "tell;x").body);
    board.sendNext();
    ASSERT_EQ(std::string(1, static_cast<char>(i)) + SENT, board.poll().texts('T').at(0));
  }
}

TEST_F(BoardTransmitting, tries_again_with_a_radio_that_refuses) {
  board.radio.refuses = true;
  board.transmit("////", "SUPP", "tell;x");
  board.pass(1000);
  EXPECT_TRUE(board.poll().records.empty());
  board.radio.refuses = false;
  board.pass(1);
  EXPECT_EQ(1u, board.radio.sent.size());
}

TEST_F(BoardTransmitting, lets_the_cpu_sleep_while_only_time_has_to_pass) {
  board.transmit("SUHO", "SUPP", "tell;x");
  EXPECT_TRUE(board.board->isIdle()) << "the packet is on the air";
  board.finishSending();
  EXPECT_TRUE(board.board->isIdle()) << "an acknowledgement is awaited";
}

TEST_F(BoardTransmitting, a_repeated_request_is_sent_once) {
  const Bytes request = reference::packet(200, plain("////", "SUPP", "tell;x"));
  const std::vector<Bytes> first = board.sendRaw(request);
  board.sendNext();
  EXPECT_EQ(first, board.sendRaw(request));
  board.pass(2000);
  EXPECT_EQ(1u, board.radio.sent.size());
}

TEST_F(BoardTransmitting, a_message_whose_key_is_deleted_while_it_waits_is_undelivered_and_not_sent) {
  board.transmit("////", "SUPP", "tell;x");
  board.transmit("SUHO", "SUPP", "tell;y");
  board.transmit("//SU", "SUPP", "tell;z");
  board.request('D', bytesOf("SUHO"));
  board.request('D', bytesOf("//SU"));
  board.sendNext();
  board.pass(2000);
  EXPECT_EQ(1u, board.radio.sent.size());
  EXPECT_EQ((std::vector<std::string>{std::string("\0\0", 2), "\1\2", "\2\2"}), board.poll().texts('T'));
}

TEST_F(BoardTransmitting, no_nonce_comes_twice_over_1000_messages_torn_writes_and_reboots) {
  RandomBytes random(14);
  std::set<Bytes> nonces;
  int sent = 0;
  while (sent < 1000) {
    if (random.number(3) == 0) board.eeprom.cutPowerAfter(static_cast<int>(random.number(12)), random.byte());
    try {
      board.start();
    } catch (const PowerCut &) {
      board.eeprom.restorePower();
      continue;
    }
    board.eeprom.restorePower();
    for (uint32_t i = random.number(20); i > 0; i--) {
      ASSERT_EQ(Status::OK, board.transmit("//SU", "SUPP", "tell;x").status);
      const Bytes frame = board.sendNext();
      ASSERT_TRUE(nonces.insert(Bytes(frame.begin() + 10, frame.begin() + 16)).second) << toHex(frame);
      EXPECT_EQ(frame, board.sendNext());
      board.poll();
      sent++;
    }
  }
}
