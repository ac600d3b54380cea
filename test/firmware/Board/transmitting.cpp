#include <gtest/gtest.h>

#include <set>

#include "support/Reference.h"
#include "support/TestBoard.h"

using javino::Counter;
using javino::Status;

namespace {

const Bytes KEY = fromHex("000102030405060708090a0b0c0d0e0f");

class BoardTransmitting : public testing::Test {
 protected:
  BoardTransmitting() {
    board.start("SUPP");
    board.setKey("SUHO", KEY);
    board.setKey("//SU", KEY);
  }

  Bytes lastSent() { return board.radio.sent.back(); }

  TestBoard board;
};

}  // namespace

TEST_F(BoardTransmitting, sends_a_broadcast_as_it_is) {
  EXPECT_EQ(Bytes{0}, board.transmit("////", "SUPP", "tell;help").body);
  EXPECT_EQ("////SUPPBItell;help", textOf(lastSent()));
}

TEST_F(BoardTransmitting, seals_unicast_and_multicast_with_the_boot_epoch_and_a_counter) {
  board.transmit("SUHO", "SUPP", "tell;x");
  EXPECT_EQ(sealed(KEY, "SUHO", "SUPP", {0, 0, 2, 0, 0, 0}, "tell;x"), lastSent());
  board.finishSending();
  board.transmit("//SU", "SUPP", "tell;x");
  EXPECT_EQ(sealed(KEY, "//SU", "SUPP", {0, 0, 2, 0, 0, 1}, "tell;x"), lastSent());
}

TEST_F(BoardTransmitting, reports_each_outcome_once_and_in_order) {
  for (int i = 0; i < 3; i++) {
    EXPECT_EQ(Bytes{static_cast<uint8_t>(i)}, board.transmit("////", "SUPP", "tell;x").body);
  }
  EXPECT_TRUE(board.poll().records.empty()) << "the first is still on the air";
  board.finishSending();
  board.finishSending();
  EXPECT_EQ((std::vector<std::string>{std::string("\0\0", 2), std::string("\1\0", 2)}), board.poll().texts('T'));
  EXPECT_TRUE(board.poll().records.empty());
  board.finishSending();
  EXPECT_EQ((std::vector<std::string>{std::string("\2\0", 2)}), board.poll().texts('T'));
  EXPECT_EQ(3u, board.counter(Counter::RADIO_SENT));
}

TEST_F(BoardTransmitting, a_host_that_never_polls_loses_no_outcome) {
  unsigned accepted = 0;
  while (board.transmit("////", "SUPP", "tell;x").status == Status::OK) {
    accepted++;
    board.finishSending();
  }
  EXPECT_EQ(javino::Transmitter::MAX_UNREPORTED, accepted);
  EXPECT_EQ(accepted, board.poll().texts('T').size());
  EXPECT_EQ(Status::OK, board.transmit("////", "SUPP", "tell;x").status);
}

TEST_F(BoardTransmitting, transmission_numbers_run_around_after_255) {
  for (int i = 0; i < 600; i++) {
    ASSERT_EQ(Bytes{static_cast<uint8_t>(i)}, board.transmit("////", "SUPP", "tell;x").body);
    board.finishSending();
    ASSERT_EQ(std::string(1, static_cast<char>(i)) + std::string(1, '\0'), board.poll().texts('T').at(0));
  }
}

TEST_F(BoardTransmitting, waits_for_a_radio_that_refuses) {
  board.radio.refuses = true;
  board.transmit("////", "SUPP", "tell;x");
  EXPECT_FALSE(board.board->isIdle());
  EXPECT_TRUE(board.poll().records.empty());
  board.radio.refuses = false;
  board.board->run();
  EXPECT_EQ(1u, board.radio.sent.size());
  EXPECT_TRUE(board.board->isIdle()) << "nothing to do while the packet is on the air";
}

TEST_F(BoardTransmitting, a_repeated_request_is_sent_once) {
  const Bytes request = reference::packet(200, plain("////", "SUPP", "tell;x"));
  const std::vector<Bytes> first = board.sendRaw(request);
  board.finishSending();
  EXPECT_EQ(first, board.sendRaw(request));
  EXPECT_EQ(1u, board.radio.sent.size());
  EXPECT_TRUE(board.board->isIdle());
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
      ASSERT_EQ(Status::OK, board.transmit("SUHO", "SUPP", "tell;x").status);
      const Bytes frame = lastSent();
      ASSERT_TRUE(nonces.insert(Bytes(frame.begin() + 10, frame.begin() + 16)).second) << toHex(frame);
      board.finishSending();
      board.poll();
      sent++;
    }
  }
}
