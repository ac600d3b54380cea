#include <gtest/gtest.h>

#include <delivery/Fragments.h>

#include "support/Digits.h"
#include "support/Keys.h"
#include "support/Fragments.h"
#include "support/Reference.h"
#include "support/TestBoard.h"
#include "support/Vectors.h"

using javinolib::Counter;

namespace {

// A board SUHO that hears SUPP and sends to it.
class InFragments : public testing::Test {
 protected:
  InFragments() {
    board.start("SUHO");
    board.setKey("SUPP", KEY);
    board.setKey("//SU", KEY);
  }

  Bytes longFrame(uint8_t counter = 2, const std::string &to = "SUHO") {
    return sealed(KEY, to, "SUPP", {0, 0, 5, 0, 1, counter}, content);
  }

  std::vector<Bytes> answers() {
    board.passSending(500);
    std::vector<Bytes> sent;
    sent.swap(board.radio.sent);
    return sent;
  }

  Bytes answer(uint8_t have) { return acknowledgement(KEY, "SUPP", "SUHO", NONCE, 7, {have}); }

  const std::string content = std::string(494, 'x');
  TestBoard board;
};

}  // namespace

TEST(Fragments, are_cut_as_in_the_vectors) {
  for (const Vector &vector : vectors("fragments.json", "valid")) {
    const size_t id = digits().find(vector.text("id"));
    EXPECT_EQ(vector.bytesList("fragments"), cut(vector.bytes("frame"), static_cast<uint8_t>(id))) << vector.toString();
  }
}

TEST(Fragments, that_are_invalid_in_the_vectors_are_dropped_and_counted) {
  TestBoard board;
  board.start("SUPO");
  board.setKey("ROMA", KEY);
  for (const Vector &vector : vectors("fragments.json", "invalid")) {
    const Bytes fragment = vector.bytes("fragment");
    if (fragment.size() > javinolib::MAX_RADIO_PAYLOAD) continue;
    const uint32_t before = board.counter(Counter::RADIO_FRAGMENTS_DROPPED) + board.counter(Counter::RADIO_BAD_FRAMES);
    board.receive(fragment);
    EXPECT_EQ(before + 1, board.counter(Counter::RADIO_FRAGMENTS_DROPPED) + board.counter(Counter::RADIO_BAD_FRAMES))
        << vector.toString();
  }
  board.pass(6000);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_EXPIRED)) << "none of them was kept";
}

TEST_F(InFragments, a_message_is_put_together_in_any_order) {
  RandomBytes random(21);
  for (uint8_t round = 0; round < 20; round++) {
    std::vector<Bytes> fragments = cut(longFrame(round), round);
    for (size_t i = fragments.size() - 1; i > 0; i--)
      std::swap(fragments[i], fragments[random.number(static_cast<uint32_t>(i + 1))]);
    for (const Bytes &fragment : fragments) board.receive(fragment);
    ASSERT_EQ(1u, board.messages().size()) << int(round);
    EXPECT_EQ(content, board.messages()[0].content);
    board.pollTaking(round);
  }
}

TEST_F(InFragments, a_fragment_that_wants_an_answer_is_told_what_is_here) {
  const std::vector<Bytes> fragments = cut(longFrame(), 9);
  board.receive(wantingAnswer(fragments[3]));
  EXPECT_TRUE(answers().empty()) << "without the first fragment nobody knows whom it is for";
  board.receive(fragments[0]);
  EXPECT_TRUE(answers().empty());
  board.receive(wantingAnswer(fragments[7]));
  EXPECT_EQ(std::vector<Bytes>{answer(0x89)}, answers());
  board.receive(wantingAnswer(fragments[0]));
  EXPECT_EQ(std::vector<Bytes>{answer(0x89)}, answers());
}

TEST_F(InFragments, the_first_fragment_of_the_last_message_taken_is_acknowledged_again) {
  const std::vector<Bytes> fragments = cut(longFrame(), 9);
  for (const Bytes &fragment : fragments) board.receive(fragment);
  board.receive(wantingAnswer(fragments[0]));
  EXPECT_TRUE(answers().empty()) << "it still waits for the host";
  board.pollTaking(0);
  answers();
  board.receive(wantingAnswer(fragments[0]));
  EXPECT_EQ(std::vector<Bytes>{acknowledgement(KEY, "SUPP", "SUHO", NONCE, 6)}, answers());
  for (const Bytes &fragment : fragments) board.receive(fragment);
  EXPECT_TRUE(board.messages().empty());
  board.pass(6000);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_EXPIRED)) << "a repeat takes no memory";
}

TEST_F(InFragments, a_message_with_any_fragment_changed_is_refused_whole_and_good_when_it_comes_right) {
  const std::vector<Bytes> fragments = cut(longFrame(), 9);
  for (size_t changed = 0; changed < fragments.size(); changed++) {
    for (size_t i = 0; i < fragments.size(); i++) {
      Bytes fragment = fragments[i];
      if (i == changed) fragment.back() = static_cast<uint8_t>(fragment.back() ^ 1);
      board.receive(fragment);
    }
    EXPECT_TRUE(board.messages().empty());
    board.pass(6000);
  }
  EXPECT_EQ(fragments.size(), board.counter(Counter::RADIO_BAD_TAG));
  for (const Bytes &fragment : fragments) board.receive(fragment);
  EXPECT_EQ(1u, board.messages().size());
}

TEST_F(InFragments, a_forged_fragment_at_any_time_does_not_shut_out_the_one_that_it_stands_for) {
  RandomBytes random(22);
  uint8_t counter = 0;
  for (size_t forged = 0; forged < 8; forged++) {
    for (size_t at = 0; at < 8; at++) {
      counter++;
      const std::vector<Bytes> fragments = cut(longFrame(counter), counter % 64);
      Bytes other = fragments[forged];
      for (size_t i = forged == 0 ? 20 : 10; i < other.size(); i++) other[i] = random.byte();
      for (size_t i = 0; i < fragments.size(); i++) {
        if (i == at) board.receive(other);
        board.receive(fragments[i]);
      }
      ASSERT_EQ(1u, board.messages().size()) << "fragment " << forged << " forged before fragment " << at;
      EXPECT_EQ(content, board.messages()[0].content);
      board.pollTaking(static_cast<uint8_t>(counter - 1));
    }
  }
}

TEST_F(InFragments, a_forged_last_fragment_does_not_shut_out_the_one_that_came_before_all_others) {
  const std::vector<Bytes> fragments = cut(longFrame(), 9);
  Bytes forged = fragments[7];
  forged.back() = static_cast<uint8_t>(forged.back() ^ 1);
  board.receive(fragments[7]);
  board.receive(forged);
  for (size_t i = 0; i < 7; i++) board.receive(fragments[i]);
  ASSERT_EQ(1u, board.messages().size());
  EXPECT_EQ(content, board.messages()[0].content);
}

TEST_F(InFragments, a_forged_fragment_of_one_byte_fixes_no_length) {
  uint8_t counter = 0;
  for (size_t index = 1; index < 8; index++) {
    for (size_t at = 0; at < 8; at++) {
      counter++;
      const std::vector<Bytes> fragments = cut(longFrame(counter), counter % 64);
      Bytes shortened = fragments[index];
      shortened.resize(11);
      shortened[8] = 'A';
      shortened[9] = 'I';
      for (size_t i = 0; i < fragments.size(); i++) {
        if (i == at) board.receive(shortened);
        board.receive(fragments[i]);
      }
      ASSERT_EQ(1u, board.messages().size()) << "fragment " << index << " forged before fragment " << at;
      board.pollTaking(static_cast<uint8_t>(counter - 1));
    }
  }
}

TEST_F(InFragments,
       a_forged_first_fragment_of_another_length_shuts_out_no_fragment_and_lets_none_of_that_length_in_later) {
  const std::vector<Bytes> fragments = cut(longFrame(), 9);
  board.receive(fragments[0]);
  board.receive(cut(sealed(OTHER_KEY, "SUHO", "SUPP", NONCE, std::string(200, 'y')), 9)[0]);
  for (size_t i = 1; i < fragments.size(); i++) board.receive(fragments[i]);
  ASSERT_EQ(1u, board.messages().size());
  EXPECT_EQ(content, board.messages()[0].content);
  board.pollTaking(0);
  board.receive(cut(sealed(KEY, "SUHO", "SUPP", {0, 0, 5, 0, 1, 3}, std::string(200, 'z')), 10)[0]);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_FRAGMENTS_DROPPED));
  board.receive(cut(longFrame(), 10)[7]);
  EXPECT_EQ(1u, board.counter(Counter::RADIO_FRAGMENTS_DROPPED));
}

TEST_F(InFragments, the_fragment_that_came_last_is_asked_for_again_where_the_whole_is_not_genuine) {
  for (uint8_t last = 1; last < 8; last++) {
    const std::vector<Bytes> fragments = cut(longFrame(last), last);
    for (size_t i = 0; i < fragments.size(); i++) {
      if (i != last) board.receive(fragments[i]);
    }
    Bytes wrong = fragments[last];
    wrong.back() = static_cast<uint8_t>(wrong.back() ^ 1);
    answers();
    board.receive(wantingAnswer(wrong));
    const Bytes nonce(fragments[0].begin() + 20, fragments[0].begin() + 26);
    const uint8_t others = static_cast<uint8_t>(~(1 << last));
    EXPECT_EQ(std::vector<Bytes>{acknowledgement(KEY, "SUPP", "SUHO", nonce, 7, {others})}, answers()) << int(last);
    board.receive(fragments[last]);
    EXPECT_EQ(1u, board.messages().size()) << int(last);
    board.pollTaking(static_cast<uint8_t>(last - 1));
  }
}

TEST_F(InFragments, a_forged_first_fragment_to_others_or_of_what_was_taken_ends_no_message) {
  const std::vector<Bytes> before = cut(longFrame(1), 8);
  for (const Bytes &fragment : before) board.receive(fragment);
  board.pollTaking(0);
  const std::vector<Bytes> fragments = cut(longFrame(2), 9);
  const Bytes toOthers = cut(sealed(KEY, "SUAM", "SUPP", NONCE, content), 9)[0];
  Bytes taken = before[0];
  taken[2] = fragments[0][2];
  for (size_t i = 0; i < fragments.size(); i++) {
    board.receive(fragments[i]);
    board.receive(toOthers);
    board.receive(taken);
  }
  EXPECT_EQ(1u, board.messages().size());
}

TEST_F(InFragments, a_half_received_message_is_forgotten_5_s_after_its_last_new_fragment) {
  const std::vector<Bytes> fragments = cut(longFrame(), 9);
  board.receive(fragments[0]);
  board.pass(4900);
  board.receive(fragments[1]);
  board.pass(4900);
  board.receive(fragments[1]);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_EXPIRED));
  board.pass(200);
  EXPECT_EQ(1u, board.counter(Counter::RADIO_EXPIRED)) << "a fragment that is here already is no new one";
}

TEST_F(InFragments, fragments_of_four_of_others_messages_take_no_memory) {
  for (size_t index : {0, 1}) {
    for (uint8_t id = 0; id < 4; id++)
      board.receive(cut(sealed(KEY, "SUAM", "SUPO", {0, 0, 5, 0, 1, id}, content), id)[index]);
  }
  board.pass(10000);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_EXPIRED));
}

TEST_F(InFragments, fragments_of_a_broadcast_that_is_here_take_no_memory_when_they_come_again) {
  const std::vector<Bytes> fragments = cut(plain("////", "SUPP", content), 3);
  for (const Bytes &fragment : fragments) board.receive(fragment);
  EXPECT_EQ(1u, board.messages().size());
  board.receive(fragments[0]);
  board.receive(fragments[1]);
  board.pass(10000);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_EXPIRED));
}

TEST_F(InFragments, fragments_of_others_messages_take_no_memory_once_the_first_has_shown_it) {
  const std::vector<Bytes> others = cut(sealed(KEY, "SUAM", "SUPO", NONCE, content), 3);
  board.receive(others[1]);
  for (const Bytes &fragment : others) board.receive(fragment);
  EXPECT_EQ(1u, board.counter(Counter::RADIO_NOT_FOR_US));
  board.pass(10000);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_EXPIRED));
}

TEST_F(InFragments, messages_of_two_senders_may_interleave) {
  board.setKey("SUAM", KEY);
  const std::vector<Bytes> one = cut(longFrame(), 9);
  const std::vector<Bytes> other = cut(sealed(KEY, "SUHO", "SUAM", NONCE, std::string(400, 'y')), 9);
  for (size_t i = 0; i < 8; i++) {
    board.receive(one[i]);
    if (i < other.size()) board.receive(other[i]);
    if (i == 6) board.pollTaking(0);
  }
  EXPECT_EQ(1, board.messages().at(0).number);
  EXPECT_EQ(content, board.messages().at(0).content);
}

TEST_F(InFragments, the_first_of_two_messages_may_end_while_the_second_lies_in_the_inbox) {
  board.setKey("SUAM", KEY);
  const std::string shorter(400, 'y');
  const std::vector<Bytes> first = cut(sealed(KEY, "SUHO", "SUAM", NONCE, shorter), 9);
  const std::vector<Bytes> second = cut(longFrame(), 9);
  for (size_t i = 0; i < second.size(); i++) {
    if (i < first.size()) board.receive(first[i]);
    board.receive(second[i]);
    if (i + 1 != first.size()) continue;
    board.receive(plain("////", "SUPO", "tell;help"));
    EXPECT_EQ(shorter, board.messages().at(0).content);
    EXPECT_EQ("tell;help", board.messages().at(1).content);
    board.pollTaking(1);
  }
  EXPECT_EQ(content, board.messages().at(0).content);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_FRAGMENTS_DROPPED));
}

TEST_F(InFragments, of_two_messages_one_comes_where_short_ones_wait_for_the_host) {
  board.setKey("SUAM", KEY);
  for (const char *sender : {"SUPO", "SURA"}) board.receive(plain("////", sender, std::string(40, 'z')));
  const std::vector<Bytes> first = cut(longFrame(), 9);
  const std::vector<Bytes> second = cut(sealed(KEY, "SUHO", "SUAM", NONCE, std::string(400, 'y')), 9);
  for (size_t i = 0; i < first.size(); i++) {
    board.receive(first[i]);
    if (i < second.size()) board.receive(second[i]);
  }
  EXPECT_EQ(second.size(), board.counter(Counter::RADIO_FRAGMENTS_DROPPED));
  board.pollTaking(1);
  EXPECT_EQ(content, board.messages().at(0).content);
}

TEST_F(InFragments, a_flood_of_messages_that_never_end_stops_no_short_one_and_long_ones_for_5_s_at_most) {
  for (int i = 0; i < 200; i++) {
    const std::string origin = "AA" + std::string(1, static_cast<char>('A' + i % 26)) + static_cast<char>('A' + i / 26);
    board.receive(cut(plain("////", origin, content), static_cast<uint8_t>(i % 64))[i % 2]);
    board.pass(10);
  }
  EXPECT_GT(board.counter(Counter::RADIO_FRAGMENTS_DROPPED), 100u);
  board.receive(plain("////", "SUPO", "tell;help"));
  EXPECT_EQ(1u, board.messages().size());
  board.pollTaking(0);
  board.pass(5000);
  for (const Bytes &fragment : cut(longFrame(), 9)) board.receive(fragment);
  EXPECT_EQ(1u, board.messages().size());
}

TEST_F(InFragments, a_unicast_is_sent_again_only_where_fragments_are_lacking) {
  board.transmit("SUPP", "SUHO", std::string(300, 'y'));
  std::vector<Bytes> sent;
  for (int i = 0; i < 5; i++) sent.push_back(board.sendNext());
  const Bytes nonce(sent[0].begin() + 20, sent[0].begin() + 26);
  EXPECT_EQ('M', sent[4][3]) << "only the last one wants an answer";
  board.receive(acknowledgement(KEY, "SUHO", "SUPP", nonce, 7, {0x15}));
  EXPECT_EQ(sent[1], board.sendNext());
  EXPECT_EQ(wantingAnswer(sent[3]), board.sendNext());
  EXPECT_EQ(wantingAnswer(sent[3]), board.sendNext()) << "no answer came: it asks again, the first one is there";
  EXPECT_EQ(wantingAnswer(sent[0]), board.sendNext()) << "or was";
  board.receive(acknowledgement(KEY, "SUHO", "SUPP", nonce, 7, {0x17}));
  EXPECT_EQ(wantingAnswer(sent[3]), board.sendNext());
  board.receive(acknowledgement(KEY, "SUHO", "SUPP", nonce, 6));
  EXPECT_EQ((std::vector<std::string>{std::string("\0\1", 2)}), board.poll().texts('T'));
}

TEST_F(InFragments, the_first_fragment_asks_as_long_as_the_receiver_has_not_said_that_it_has_it) {
  board.transmit("SUPP", "SUHO", std::string(100, 'y'));
  const Bytes first = board.sendNext();
  board.sendNext();
  for (int i = 0; i < 7; i++) EXPECT_EQ(wantingAnswer(first), board.sendNext());
}

TEST_F(InFragments, what_an_answer_asks_for_follows_it_after_a_quiet_slot) {
  for (int round = 0; round < 50; round++) {
    board.start("SUHO");
    board.transmit("SUPP", "SUHO", std::string(100, 'y'));
    const Bytes first = board.sendNext();
    board.sendNext();
    const Bytes nonce(first.begin() + 20, first.begin() + 26);
    const size_t before = board.radio.sent.size();
    board.receive(acknowledgement(KEY, "SUHO", "SUPP", nonce, 7, {1}));
    board.pass(16);
    EXPECT_EQ(before + 1, board.radio.sent.size()) << "no random wait: the air is still theirs";
  }
}

TEST_F(InFragments, answers_without_a_new_fragment_do_not_keep_a_message_alive) {
  board.transmit("SUPP", "SUHO", std::string(100, 'y'));
  board.sendNext();
  const Bytes first = board.radio.sent[0];
  const Bytes nonce(first.begin() + 20, first.begin() + 26);
  int packets = 0;
  while (board.poll().records.empty()) {
    ASSERT_LT(packets++, 30);
    board.sendNext();
    board.receive(acknowledgement(KEY, "SUHO", "SUPP", nonce, 7, {1}));
    board.pass(160);
  }
}
