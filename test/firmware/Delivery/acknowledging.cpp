#include <gtest/gtest.h>

#include <set>

#include "support/Keys.h"
#include "support/Fragments.h"
#include "support/TestBoard.h"

using javinolib::Counter;

namespace {

// A board SUHO that hears SUPP.
class Acknowledging : public testing::Test {
 protected:
  Acknowledging() {
    board.start("SUHO");
    board.setKey("SUPP", KEY);
    board.setKey("//SU", KEY);
  }

  // The packets that the board has sent since it was last asked, and sends within half a second.
  std::vector<Bytes> answers() {
    board.passSending(500);
    std::vector<Bytes> sent;
    sent.swap(board.radio.sent);
    return sent;
  }

  Bytes delivered() { return acknowledgement(KEY, "SUPP", "SUHO", NONCE, 6); }

  const Bytes frame = sealed(KEY, "SUHO", "SUPP", NONCE, "tell;x");
  TestBoard board;
};

}  // namespace

TEST_F(Acknowledging, a_unicast_is_acknowledged_when_the_host_has_taken_it_and_not_before) {
  board.receive(frame);
  EXPECT_TRUE(answers().empty());
  EXPECT_EQ(fromHex("050102"), board.messages().at(0).id);
  EXPECT_TRUE(answers().empty()) << "the host was given it, and may have died";
  board.pollTaking(0);
  EXPECT_EQ(std::vector<Bytes>{delivered()}, answers());
  EXPECT_TRUE(answers().empty());
}

TEST_F(Acknowledging, a_repeat_is_not_answered_while_the_message_waits_and_acknowledged_again_when_it_is_taken) {
  board.receive(frame);
  board.receive(frame);
  EXPECT_TRUE(answers().empty());
  EXPECT_EQ(1u, board.messages().size());
  board.pollTaking(0);
  answers();
  board.receive(frame);
  EXPECT_EQ(std::vector<Bytes>{delivered()}, answers());
  EXPECT_TRUE(board.messages().empty());
  EXPECT_EQ(2u, board.counter(Counter::RADIO_REPEATS));
}

TEST_F(Acknowledging, a_multicast_and_a_broadcast_are_not_acknowledged) {
  board.receive(sealed(KEY, "//SU", "SUPP", NONCE, "tell;x"));
  board.receive(plain("////", "SUPP", "tell;x"));
  board.pollTaking(1);
  board.receive(sealed(KEY, "//SU", "SUPP", NONCE, "tell;x"));
  EXPECT_TRUE(answers().empty());
  EXPECT_EQ(1u, board.counter(Counter::RADIO_REPEATS));
}

TEST_F(Acknowledging, one_taken_acknowledges_all_that_it_covers) {
  board.setKey("SUAM", OTHER_KEY);
  board.receive(frame);
  board.receive(sealed(OTHER_KEY, "SUHO", "SUAM", NONCE, "tell;y"));
  board.pollTaking(1);
  EXPECT_EQ((std::vector<Bytes>{delivered(), acknowledgement(OTHER_KEY, "SUAM", "SUHO", NONCE, 6)}), answers());
}

TEST_F(Acknowledging, a_message_whose_key_was_replaced_is_given_to_the_host_and_not_acknowledged) {
  board.receive(frame);
  board.setKey("SUPP", OTHER_KEY);
  EXPECT_EQ(1u, board.messages().size());
  board.pollTaking(0);
  EXPECT_TRUE(answers().empty());
}

TEST_F(Acknowledging, frames_under_the_previous_key_are_accepted_and_acknowledged_with_it) {
  board.request('N', bytesOf("SUPP") + OTHER_KEY);
  board.request('U', bytesOf("SUPP"));
  board.receive(frame);
  board.pollTaking(0);
  EXPECT_EQ(std::vector<Bytes>{delivered()}, answers());
  board.request('F', bytesOf("SUPP"));
  board.receive(sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 3}, "tell;x"));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_BAD_TAG));
}

TEST_F(Acknowledging, frames_under_the_next_key_are_accepted_and_acknowledged_with_it) {
  board.request('N', bytesOf("SUPP") + OTHER_KEY);
  board.receive(sealed(OTHER_KEY, "SUHO", "SUPP", NONCE, "tell;x"));
  board.request('U', bytesOf("SUPP"));
  board.pollTaking(0);
  EXPECT_EQ((std::vector<Bytes>{acknowledgement(OTHER_KEY, "SUPP", "SUHO", NONCE, 6)}), answers());
}

TEST_F(Acknowledging, a_blocked_board_neither_receives_nor_acknowledges_but_settles_what_waits) {
  board.receive(frame);
  board.request('R', {0});
  board.receive(sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 3}, "tell;y"));
  EXPECT_EQ(1u, board.messages().size());
  board.pollTaking(0);
  EXPECT_EQ(std::vector<Bytes>{delivered()}, answers());
  board.receive(frame);
  EXPECT_TRUE(answers().empty());
  EXPECT_EQ(2u, board.counter(Counter::RADIO_BLOCKED));
}

TEST_F(Acknowledging, six_wait_and_the_oldest_of_more_is_dropped_and_counted) {
  board.radio.heard = true;
  for (char last = 'A'; last <= 'G'; last++) {
    const std::string sender = std::string("SUX") + last;
    board.setKey(sender, KEY);
    board.receive(sealed(KEY, "SUHO", sender, NONCE, "tell;x"));
    board.pollTaking(static_cast<uint8_t>(last - 'A'));
  }
  EXPECT_EQ(1u, board.counter(Counter::RADIO_ANSWERS_DROPPED));
  board.radio.heard = false;
  board.passSending(2000);
  ASSERT_EQ(6u, board.radio.sent.size());
  EXPECT_EQ(acknowledgement(KEY, "SUXB", "SUHO", NONCE, 6), board.radio.sent.front());
}

TEST_F(Acknowledging, waits_for_the_carrier_to_end_and_is_counted_once) {
  board.radio.heard = true;
  board.receive(frame);
  board.pollTaking(0);
  EXPECT_TRUE(answers().empty());
  EXPECT_EQ(1u, board.counter(Counter::RADIO_DEFERRED));
  board.radio.heard = false;
  EXPECT_EQ(1u, answers().size());
}

TEST_F(Acknowledging, goes_at_once_where_the_air_is_quiet_and_after_2_to_5_slots_where_it_was_not) {
  std::set<uint32_t> waits;
  for (uint8_t number = 0; number < 100; number++) {
    const bool isBusy = number != 0;
    board.radio.heard = isBusy;
    board.receive(sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, number}, "tell;x"));
    board.pollTaking(number);
    board.pass(1);
    board.radio.heard = false;
    const uint32_t from = board.clock.millis;
    board.nextSent();
    const uint32_t wait = board.clock.millis - from;
    if (isBusy) {
      waits.insert(wait / 8);
    } else {
      EXPECT_LE(wait, 1u);
    }
    board.finishSending();
    board.pass(200);
  }
  EXPECT_EQ((std::set<uint32_t>{2, 3, 4, 5}), waits);
}

TEST_F(Acknowledging, goes_first_even_while_the_board_awaits_an_acknowledgement_itself) {
  board.transmit("SUPP", "SUHO", "tell;mine");
  board.sendNext();
  board.receive(frame);
  board.pollTaking(0);
  EXPECT_EQ(delivered(), board.sendNext());
}

TEST_F(Acknowledging, a_board_that_lost_its_RAM_tells_the_sender_its_floor_and_how_long_it_is_up) {
  board.receive(frame);
  board.pollTaking(0);
  board.powerUp();
  board.hello();
  board.request('R', {1});
  board.pass(200);
  board.receive(sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 3}, "tell;y"));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_STALE));
  const Bytes told = board.nextSent();
  const uint8_t uptime = told.at(17);
  EXPECT_TRUE(uptime == 2) << int(uptime);
  EXPECT_EQ(acknowledgement(KEY, "SUPP", "SUHO", {0, 0, 5, 0, 1, 3}, 8, fromHex("000005000121") + Bytes{0, uptime}),
            told);
  board.finishSending();
  board.receive(sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 0x22}, "tell;y"));
  EXPECT_EQ("tell;y", board.messages().at(0).content);
}

TEST_F(Acknowledging, a_reset_that_keeps_the_RAM_refuses_nothing_new) {
  board.receive(frame);
  board.pollTaking(0);
  board.start();
  board.receive(frame);
  EXPECT_EQ(std::vector<Bytes>{delivered()}, answers()) << "the last one taken is still known";
  board.receive(sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 3}, "tell;y"));
  EXPECT_EQ(1u, board.messages().size());
}

TEST_F(Acknowledging, knows_a_broadcast_that_comes_again_at_once_and_no_other) {
  const Bytes broadcast = plain("////", "SUPP", "tell;help");
  const uint32_t airtime = 42 + 6 * static_cast<uint32_t>(broadcast.size());
  board.pass(1000);
  board.receive(broadcast);
  board.pass(400 + airtime);
  board.receive(broadcast);
  EXPECT_EQ(1u, board.messages().size());
  board.receive(plain("////", "SUPO", "tell;help"));
  board.receive(plain("////", "SUPP", "tell;fire"));
  EXPECT_EQ(3u, board.messages().size());
  board.pass(401 + airtime);
  board.receive(plain("////", "SUPP", "tell;fire"));
  EXPECT_EQ(4u, board.messages().size());
  EXPECT_EQ(1u, board.counter(Counter::RADIO_REPEATS));
}
