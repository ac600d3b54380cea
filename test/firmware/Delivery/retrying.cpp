#include <gtest/gtest.h>

#include "support/Keys.h"
#include "support/Fragments.h"
#include "support/TestBoard.h"

using javinolib::Counter;

namespace {

// A board SUPP that sends to SUHO, in its second boot.
class Retrying : public testing::Test {
 protected:
  Retrying() {
    board.start("SUPP");
    board.setKey("SUHO", KEY);
    board.setKey("//SU", KEY);
    board.start();
    board.transmit("SUHO", "SUPP", "tell;x");
    first = board.sendNext();
    nonce = Bytes(first.begin() + 10, first.begin() + 16);
  }

  Bytes answer(uint8_t type, const Bytes &body = Bytes()) {
    return acknowledgement(KEY, "SUPP", "SUHO", nonce, type, body);
  }

  // A floor this far above the nonce that is under way, and an uptime in tenths of a second.
  Bytes floor(int above, uint16_t uptime) {
    Bytes body = nonce;
    body[5] = static_cast<uint8_t>(body[5] + above);
    return body + Bytes{static_cast<uint8_t>(uptime >> 8), static_cast<uint8_t>(uptime)};
  }

  std::vector<std::string> outcomes() { return board.poll().texts('T'); }

  TestBoard board;
  Bytes first;
  Bytes nonce;
};

}  // namespace

TEST_F(Retrying, a_unicast_without_an_answer_is_sent_8_times_byte_for_byte_and_is_then_undelivered) {
  for (int attempt = 2; attempt <= 8; attempt++) {
    EXPECT_TRUE(outcomes().empty());
    EXPECT_EQ(first, board.sendNext()) << attempt;
  }
  board.pass(599);
  EXPECT_TRUE(outcomes().empty());
  board.pass(2);
  EXPECT_EQ(std::vector<std::string>{UNDELIVERED}, outcomes());
  board.passSending(5000);
  EXPECT_EQ(8u, board.radio.sent.size());
  EXPECT_EQ(7u, board.counter(Counter::RADIO_RESENT));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_UNDELIVERED));
}

TEST_F(Retrying, an_acknowledgement_ends_it_at_any_moment) {
  board.receive(answer(6));
  EXPECT_EQ(std::vector<std::string>{DELIVERED}, outcomes());
  board.passSending(2000);
  EXPECT_EQ(1u, board.radio.sent.size());
  board.receive(answer(6));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_NOT_FOR_US)) << "nothing is under way any more";
  EXPECT_EQ(1u, board.counter(Counter::RADIO_ACKNOWLEDGED));
}

TEST_F(Retrying, a_late_acknowledgement_still_counts_while_it_is_being_sent_again) {
  board.nextSent();
  board.receive(answer(6));
  board.finishSending();
  EXPECT_EQ(std::vector<std::string>{DELIVERED}, outcomes());
  board.passSending(2000);
  EXPECT_EQ(2u, board.radio.sent.size());
}

TEST_F(Retrying, is_acknowledged_though_the_radio_is_blocked) {
  board.request('R', {0});
  board.receive(answer(6));
  EXPECT_EQ(std::vector<std::string>{DELIVERED}, outcomes());
}

TEST_F(Retrying, no_acknowledgement_with_any_bit_changed_and_none_from_another_ends_it) {
  for (const Bytes &good : {answer(6), answer(8, floor(0, 9999))}) {
    for (size_t bit = 0; bit < good.size() * 8; bit++) {
      Bytes changed = good;
      changed[bit / 8] = static_cast<uint8_t>(changed[bit / 8] ^ 1 << bit % 8);
      board.receive(changed);
    }
    for (size_t length = 1; length < good.size(); length++)
      board.receive(Bytes(good.begin(), good.begin() + static_cast<long>(length)));
  }
  board.receive(acknowledgement(KEY, "SUPP", "SUAM", nonce, 6));
  board.receive(acknowledgement(KEY, "SUHO", "SUHO", nonce, 6));
  EXPECT_TRUE(outcomes().empty());
  EXPECT_GT(board.counter(Counter::RADIO_BAD_PROOFS), 100u);
  board.receive(answer(6));
  EXPECT_EQ(std::vector<std::string>{DELIVERED}, outcomes());
}

TEST_F(Retrying, time_in_which_a_carrier_is_heard_does_not_count) {
  board.pass(100);
  board.radio.heard = true;
  board.pass(5000);
  EXPECT_EQ(1u, board.radio.sent.size());
  board.radio.heard = false;
  board.pass(45);
  board.receive(answer(6));
  EXPECT_EQ(std::vector<std::string>{DELIVERED}, outcomes());
  EXPECT_EQ(1u, board.radio.sent.size());
}

TEST_F(Retrying, a_stale_notice_has_it_sealed_anew_above_the_floor_once) {
  board.receive(answer(8, floor(31, 9999)));
  const Bytes second = board.sendNext();
  Bytes raised = nonce;
  raised[5] = static_cast<uint8_t>(raised[5] + 32);
  EXPECT_EQ(sealed(KEY, "SUHO", "SUPP", raised, "tell;x"), second);
  nonce = raised;
  board.receive(answer(8, floor(31, 9999)));
  EXPECT_EQ(std::vector<std::string>{UNDELIVERED}, outcomes());
}

TEST_F(Retrying, it_is_undelivered_where_the_receiver_may_have_had_it_before_it_lost_its_memory) {
  for (int attempt = 2; attempt <= 5; attempt++) board.sendNext();
  board.receive(answer(8, floor(31, 10)));
  EXPECT_EQ(std::vector<std::string>{UNDELIVERED}, outcomes());
  board.passSending(2000);
  EXPECT_EQ(5u, board.radio.sent.size());
}

TEST_F(Retrying, it_is_sealed_anew_only_where_the_receiver_is_up_for_longer_whichever_byte_of_its_uptime_tells) {
  board.radio.heard = true;
  board.pass(30000);
  board.receive(answer(8, floor(31, 0x100)));  // 25.6 s
  EXPECT_EQ(std::vector<std::string>{UNDELIVERED}, outcomes());
  board.transmit("SUHO", "SUPP", "tell;x");
  board.radio.heard = false;
  const Bytes second = board.sendNext();
  nonce = Bytes(second.begin() + 10, second.begin() + 16);
  board.radio.heard = true;
  board.pass(30000);
  board.receive(answer(8, floor(31, 0x200)));  // 51.2 s
  EXPECT_TRUE(outcomes().empty());
}

TEST_F(Retrying, a_key_that_is_deleted_meanwhile_and_set_again_no_longer_acknowledges_it) {
  board.request('D', bytesOf("SUHO"));
  board.setKey("SUHO", KEY);
  board.receive(answer(6));
  EXPECT_EQ(std::vector<std::string>{UNDELIVERED}, outcomes());
  EXPECT_EQ(1u, board.counter(Counter::RADIO_NOT_FOR_US));
}

TEST_F(Retrying, floors_of_other_epochs_or_far_above_are_counted_and_ignored) {
  Bytes other = floor(0, 9999);
  other[2]++;
  board.receive(answer(8, other));
  board.receive(answer(8, floor(34, 9999)));
  EXPECT_EQ(2u, board.counter(Counter::RADIO_BAD_PROOFS));
  EXPECT_TRUE(outcomes().empty());
  EXPECT_EQ(first, board.sendNext());
}

TEST_F(Retrying, a_stale_notice_for_a_multicast_raises_the_counter_even_when_all_is_sent) {
  board.receive(answer(6));
  board.transmit("//SU", "SUPP", "tell;y");
  const Bytes multicast = board.sendNext();
  board.sendNext();
  nonce = Bytes(multicast.begin() + 10, multicast.begin() + 16);
  board.receive(acknowledgement(KEY, "SUPP", "SUAM", nonce, 8, floor(20, 1)));
  EXPECT_EQ(0u, board.counter(Counter::RADIO_BAD_PROOFS));
  board.transmit("SUHO", "SUPP", "tell;z");
  EXPECT_EQ(nonce[5] + 21, board.sendNext().at(15));
}

TEST_F(Retrying, an_outcome_whose_reply_was_lost_is_told_again_to_a_host_that_says_hello) {
  board.receive(answer(6));
  EXPECT_EQ(std::vector<std::string>{DELIVERED}, outcomes());
  board.hello();
  EXPECT_EQ(std::vector<std::string>{DELIVERED}, outcomes());
  EXPECT_TRUE(outcomes().empty()) << "a second poll shows that the first one's reply came";
}
