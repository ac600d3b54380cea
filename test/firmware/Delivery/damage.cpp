// A board and packets that came damaged, and what it says of them to their senders.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/Keys.h"
#include "support/Fragments.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Trailer;

namespace {

const uint8_t TYPE_DELIVERED = 0x06;
const uint8_t TYPE_FRAGMENTS = 0x07;
const uint8_t ASKS_PARITY = 0x10;

// Bits of an acknowledgement: of its count, of its header, and of its proof.
const size_t HEADER_AT = 12;
const size_t PROOF_AT = 12 + 10 * 12;

// One bit of every second symbol, so that each is wrong.
std::set<size_t> wrongSymbols(size_t from, size_t count) {
  std::set<size_t> bits;
  for (size_t i = 0; i < count; i++) bits.insert(from + 12 * i + i % 6);
  return bits;
}

std::set<size_t> both(std::set<size_t> one, const std::set<size_t> &other) {
  one.insert(other.begin(), other.end());
  return one;
}

// A board SUPP that has sent a message to SUHO, and hears as badly as an AskRadio may.
class DamagedAnswers : public testing::Test {
 protected:
  DamagedAnswers() {
    board.start("SUPP");
    board.setKey("SUHO", KEY);
    board.radio.mends = true;
    first = send("tell;x");
  }

  Bytes send(const std::string &content) {
    board.transmit("SUHO", "SUPP", content);
    const Bytes packet = board.sendNext();
    const size_t nonce = packet[0] == '+' && packet[1] == 'F' ? 20 : 10;
    this->nonce = Bytes(packet.begin() + static_cast<long>(nonce), packet.begin() + static_cast<long>(nonce) + 6);
    return packet;
  }

  Bytes answer(uint8_t type = TYPE_DELIVERED, const Bytes &body = Bytes()) {
    return acknowledgement(KEY, "SUPP", "SUHO", nonce, type, body);
  }

  void hear(const Bytes &packet, const std::set<size_t> &wrong) {
    board.radio.arrive(packet, wrong);
    board.pass(1);
  }

  bool isDelivered() {
    const std::vector<std::string> outcomes = board.poll().texts('T');
    return outcomes.size() == 1 && outcomes[0][1] == 1;
  }

  Trailer lastTrailer() const { return board.radio.trailers.back(); }

  TestBoard board;
  Bytes first;
  Bytes nonce;
};

// A board SUHO that hears SUPP like this, and has taken a message.
class DamagedMessages : public testing::Test {
 protected:
  DamagedMessages() {
    board.start("SUHO");
    board.setKey("SUPP", KEY);
    board.radio.mends = true;
    hear({});
    board.messages();
    board.pollTaking(0);
    answers();
  }

  void hear(const std::set<size_t> &wrong, Trailer trailer = Trailer::NONE) {
    board.radio.arrive(frame, wrong, trailer);
    board.pass(1);
  }

  std::vector<Bytes> answers() {
    board.passSending(900);
    std::vector<Bytes> sent;
    sent.swap(board.radio.sent);
    return sent;
  }

  Bytes delivered(uint8_t type = TYPE_DELIVERED) { return acknowledgement(KEY, "SUPP", "SUHO", nonce, type); }

  const Bytes nonce = {0, 0, 5, 0, 1, 2};
  const Bytes frame = sealed(KEY, "SUHO", "SUPP", nonce, "tell;x");
  TestBoard board;
};

}  // namespace

TEST_F(DamagedAnswers, one_with_seven_wrong_bits_of_its_proof_is_borne) {
  hear(answer(), wrongSymbols(PROOF_AT, 7));
  EXPECT_TRUE(isDelivered());
  EXPECT_EQ(1u, board.counter(Counter::RADIO_ANSWERS_TOLERATED));
}

TEST_F(DamagedAnswers, one_with_eight_is_not) {
  hear(answer(), wrongSymbols(PROOF_AT, 8));
  EXPECT_FALSE(isDelivered());
  EXPECT_EQ(0u, board.counter(Counter::RADIO_ANSWERS_TOLERATED));
}

// The chance of a forger who chooses each six bits as he likes, and even learns how many of the earlier ones were wrong: SECURITY.md.
TEST(ProofWithWrongBits, is_guessed_with_less_than_two_to_the_minus_43_9) {
  const int most = 7;
  std::vector<double> chances(most + 1, 1);  // with so many wrong bits left
  for (int symbol = 0; symbol < 16; symbol++) {
    std::vector<double> best(most + 1, 0);
    for (int sent = 0; sent < 64; sent++) {
      for (int left = 0; left <= most; left++) {
        double chance = 0;
        for (uint8_t nibble = 0; nibble < 16; nibble++) {
          const int wrong =
              javinolib::linecode::onesOf(static_cast<uint8_t>(javinolib::linecode::symbolOf(nibble) ^ sent));
          if (wrong <= left) chance += chances[static_cast<size_t>(left - wrong)] / 16;
        }
        best[static_cast<size_t>(left)] = std::max(best[static_cast<size_t>(left)], chance);
      }
    }
    chances = best;
  }
  EXPECT_LT(std::log2(chances[most]), -43.9);
}

TEST_F(DamagedAnswers, fifteen_wrong_bits_of_the_header_are_borne_beside) {
  for (size_t bits : {15, 16}) {
    board.radio.arrive(answer(), both(both(wrongSymbols(HEADER_AT, 10), wrongSymbols(HEADER_AT + 6, bits - 10)),
                                      wrongSymbols(PROOF_AT, 7)));
    board.pass(1);
    EXPECT_EQ(bits == 15, isDelivered()) << bits;
    if (bits == 15) send("tell;y");
  }
}

TEST_F(DamagedAnswers, all_of_one_that_is_another_s_are_refused) {
  const Bytes others[] = {acknowledgement(OTHER_KEY, "SUPP", "SUHO", nonce, TYPE_DELIVERED),
                          acknowledgement(KEY, "SUPP", "SUHA", nonce, TYPE_DELIVERED),
                          acknowledgement(KEY, "SUHO", "SUHO", nonce, TYPE_DELIVERED), answer(TYPE_FRAGMENTS, {1})};
  for (const Bytes &other : others) hear(other, wrongSymbols(PROOF_AT, 7));
  EXPECT_FALSE(isDelivered());
}

TEST_F(DamagedAnswers, after_sixteen_guesses_at_a_message_none_is_borne) {
  for (int left : {15, 16}) {
    for (int i = 0; i < left; i++) hear(answer(), wrongSymbols(PROOF_AT, 8));
    hear(answer(), wrongSymbols(PROOF_AT, 7));
    EXPECT_EQ(left == 15, isDelivered()) << left;
    if (left == 15) send("tell;y");
  }
  hear(answer(), {});
  EXPECT_TRUE(isDelivered()) << "an intact one is";
}

TEST_F(DamagedAnswers, what_has_arrived_of_a_message_in_fragments_is_borne_too) {
  hear(answer(), {});
  ASSERT_TRUE(isDelivered());
  send("tell;" + std::string(150, 'x'));
  board.sendNext();
  const Bytes third = board.sendNext();
  EXPECT_EQ(3u, board.radio.sent.size() - 1);
  hear(answer(TYPE_FRAGMENTS, {3}), both(wrongSymbols(PROOF_AT + 12, 7), wrongSymbols(PROOF_AT, 1)));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_ANSWERS_TOLERATED));
  EXPECT_EQ(third, board.sendNext()) << "the one that is lacking";
}

TEST_F(DamagedAnswers, what_is_borne_is_no_guess) {
  hear(answer(), {});
  ASSERT_TRUE(isDelivered());
  send("tell;" + std::string(150, 'x'));
  board.sendNext();
  board.sendNext();
  const std::set<size_t> wrong = both(wrongSymbols(PROOF_AT + 12, 7), wrongSymbols(PROOF_AT, 1));
  for (int i = 0; i < 40; i++) hear(answer(TYPE_FRAGMENTS, {3}), wrong);
  EXPECT_EQ(40u, board.counter(Counter::RADIO_ANSWERS_TOLERATED));
}

TEST_F(DamagedAnswers, packets_sent_again_have_a_mark_and_parity_once_it_was_asked_for) {
  EXPECT_EQ(Trailer::NONE, lastTrailer());
  EXPECT_EQ(first, board.sendNext());
  EXPECT_EQ(Trailer::MARK, lastTrailer());
  hear(answer(TYPE_DELIVERED | ASKS_PARITY), {});
  EXPECT_TRUE(isDelivered());

  send("tell;y");
  EXPECT_EQ(Trailer::PARITY, lastTrailer());
  hear(answer(), {});
  EXPECT_TRUE(isDelivered());

  send("tell;z");
  EXPECT_EQ(Trailer::NONE, lastTrailer()) << "the last answer did not ask for it";
  board.sendNext();
  EXPECT_EQ(Trailer::PARITY, lastTrailer()) << "the receiver is known to understand it";
}

TEST_F(DamagedAnswers, one_that_asks_for_parity_is_borne_where_a_trailer_was_sent) {
  hear(answer(TYPE_DELIVERED | ASKS_PARITY), wrongSymbols(PROOF_AT, 7));
  EXPECT_FALSE(isDelivered()) << "nobody asks for what he cannot know of";
  board.sendNext();
  hear(answer(TYPE_DELIVERED | ASKS_PARITY), wrongSymbols(PROOF_AT, 7));
  EXPECT_TRUE(isDelivered());
  send("tell;y");
  EXPECT_EQ(Trailer::PARITY, lastTrailer());
}

TEST_F(DamagedAnswers, a_message_under_another_key_has_no_parity) {
  board.setKey("ROMA", OTHER_KEY);
  board.sendNext();
  hear(answer(TYPE_DELIVERED | ASKS_PARITY), {});
  board.transmit("ROMA", "SUPP", "tell;x");
  board.sendNext();
  EXPECT_EQ(Trailer::NONE, lastTrailer());
}

TEST_F(DamagedMessages, parity_is_asked_for_where_a_mark_or_parity_shows_that_it_is_understood) {
  hear({}, Trailer::MARK);
  EXPECT_EQ(std::vector<Bytes>{delivered(TYPE_DELIVERED | ASKS_PARITY)}, answers());
  hear(wrongSymbols(50, 3), Trailer::PARITY);
  EXPECT_EQ(std::vector<Bytes>{delivered(TYPE_DELIVERED | ASKS_PARITY)}, answers());
  hear({2}, Trailer::MARK);
  EXPECT_EQ(std::vector<Bytes>{delivered(TYPE_DELIVERED | ASKS_PARITY)}, answers()) << "though its count was damaged";
  hear({}, Trailer::PARITY);
  EXPECT_EQ(std::vector<Bytes>{delivered()}, answers()) << "it was not needed";
  hear({});
  EXPECT_EQ(std::vector<Bytes>{delivered()}, answers());
}

TEST_F(DamagedMessages, a_damaged_repeat_without_a_trailer_is_acknowledged_twice) {
  hear(wrongSymbols(50, 1));
  EXPECT_EQ((std::vector<Bytes>{delivered(), delivered()}), answers());
  hear(wrongSymbols(50, 1), Trailer::MARK);
  EXPECT_EQ(std::vector<Bytes>{delivered(TYPE_DELIVERED | ASKS_PARITY)}, answers());
  hear({});
  EXPECT_EQ(std::vector<Bytes>{delivered()}, answers());
}

TEST_F(DamagedMessages, a_damaged_repeat_is_known_by_its_likeness) {
  hear(wrongSymbols(14, 20), Trailer::MARK);
  EXPECT_EQ(std::vector<Bytes>{delivered(TYPE_DELIVERED | ASKS_PARITY)}, answers());
  EXPECT_TRUE(board.messages().empty());
}

TEST_F(DamagedMessages, two_damaged_copies_make_one_message) {
  const Bytes other = sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 3}, "tell;y");
  board.radio.arrive(other, wrongSymbols(14, 20));
  board.pass(1);
  EXPECT_TRUE(board.messages().empty());
  board.radio.arrive(other, wrongSymbols(20, 20));
  board.pass(1);
  ASSERT_EQ(1u, board.messages().size());
}

TEST_F(DamagedMessages, no_forgery_takes_the_place_of_damaged_copies) {
  const Bytes other = sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 3}, "tell;a message of some length");
  const auto crcOf = [](const Bytes &payload) {
    return reference::crc(Bytes(1, static_cast<uint8_t>(payload.size() + 3)) + payload);
  };
  Bytes forged = other;
  forged[20] ^= 1;
  for (uint32_t i = 0; crcOf(forged) != crcOf(other); i++) {
    forged[25] = static_cast<uint8_t>(i);
    forged[30] = static_cast<uint8_t>(i >> 8);
  }
  board.radio.arrive(forged);
  board.pass(1);
  EXPECT_EQ(1u, board.counter(Counter::RADIO_BAD_TAG));
  board.radio.arrive(other, {100, 200, 300});
  board.pass(1);
  board.radio.arrive(other, {150, 250, 350});
  board.pass(1);
  EXPECT_EQ(1u, board.messages().size());
}

TEST_F(DamagedMessages, another_packet_s_mark_says_nothing_of_a_message_that_waits) {
  const Bytes other = sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 3}, "tell;y");
  board.radio.arrive(other);
  board.pass(1);
  std::set<size_t> all;
  for (size_t bit = 14; bit < 400; bit += 3) all.insert(bit);
  board.radio.arrive(sealed(OTHER_KEY, "SUHO", "ROMA", {0, 0, 5, 0, 1, 3}, "tell;y"), all, Trailer::MARK);
  board.pass(1);
  board.messages();
  board.pollTaking(1);
  EXPECT_EQ(std::vector<Bytes>{acknowledgement(KEY, "SUPP", "SUHO", {0, 0, 5, 0, 1, 3}, TYPE_DELIVERED)}, answers());
}

TEST_F(DamagedMessages, a_broadcast_is_taken_only_where_there_is_no_doubt) {
  const Bytes broadcast = plain("////", "SUPP", "tell;a broadcast of some length");
  board.radio.arrive(broadcast, {50});
  board.pass(1);
  EXPECT_EQ(1u, board.messages().size());
  board.pollTaking(1);
  board.radio.arrive(plain("////", "SUPP", "tell;another one of some length"), {50, 90});
  board.pass(1);
  EXPECT_TRUE(board.messages().empty());
  EXPECT_EQ(1u, board.counter(Counter::RADIO_DOUBTFUL));
}

// Its host proves it, or the words that follow.
TEST_F(DamagedMessages, a_word_of_hosts_is_taken_even_where_there_is_a_doubt) {
  const Bytes word = plain("////", "SUPP",
                           "\x88"
                           "ROMA" +
                               std::string(60, 'x'));
  std::set<size_t> some, others;
  for (size_t bit = 200; bit < 800; bit += 60) some.insert(bit);
  for (size_t bit = 230; bit < 800; bit += 60) others.insert(bit);
  board.radio.arrive(word, some);
  board.pass(1);
  EXPECT_TRUE(board.messages().empty());
  board.radio.arrive(plain("////", "SUPP", "tell;something else between both"));
  board.pass(1);
  EXPECT_EQ(1u, board.messages().size());
  board.pollTaking(1);
  board.pass(500);
  board.radio.arrive(word, others);
  board.pass(1);
  EXPECT_EQ(1u, board.messages().size());
  EXPECT_EQ(0u, board.counter(Counter::RADIO_DOUBTFUL));
}
