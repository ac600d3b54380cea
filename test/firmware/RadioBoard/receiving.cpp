#include <gtest/gtest.h>

#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::Counter;

namespace {

// A board SUHO that shares a key with SUPP and one with its group.
class BoardReceiving : public testing::Test {
 protected:
  BoardReceiving() {
    board.start("SUHO");
    board.setKey("SUPP", KEY);
    board.setKey("//SU", KEY);
  }

  // Lets a packet arrive that must be dropped and counted here, and nowhere else.
  void expectDropped(const Bytes &packet, Counter why) {
    const uint32_t before = board.counter(why);
    board.receive(packet);
    EXPECT_TRUE(board.messages().empty());
    EXPECT_EQ(before + 1, board.counter(why));
    uint32_t dropped = 0;
    for (int i = static_cast<int>(Counter::RADIO_BAD_FRAMES); i <= static_cast<int>(Counter::RADIO_QUEUE_FULL); i++) {
      dropped += board.counter(static_cast<Counter>(i));
    }
    for (Counter counter : {Counter::RADIO_REPEATS, Counter::RADIO_FRAGMENTS_DROPPED, Counter::RADIO_STALE}) {
      dropped += board.counter(counter);
    }
    EXPECT_EQ(++dropped_, dropped);
  }

  // How many messages wait: takes them, the first of which has this number.
  int waiting(uint8_t first) {
    int count = 0;
    for (std::vector<PolledMessage> some = board.messages(); !some.empty(); some = board.messages()) {
      EXPECT_EQ(first + count, some.front().number);
      count += static_cast<int>(some.size());
      board.pollTaking(some.back().number);
    }
    return count;
  }

  TestBoard board;

 private:
  uint32_t dropped_ = 0;
};

}  // namespace

TEST_F(BoardReceiving, delivers_broadcast_multicast_and_unicast_opened) {
  board.receive(plain("////", "ROMA", "tell;help"));
  board.receive(sealed(KEY, "//SU", "SUPO", nonce(1, 0), "tell;someoneNeedHelp"));
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), std::string(53, 'x')));
  const std::vector<PolledMessage> messages = board.messages();
  ASSERT_EQ(3u, messages.size());
  EXPECT_EQ(0, messages[0].number);
  EXPECT_EQ("////", messages[0].destination);
  EXPECT_EQ("ROMA", messages[0].origin);
  EXPECT_EQ("tell;help", messages[0].content);
  EXPECT_EQ("//SU", messages[1].destination);
  EXPECT_EQ("tell;someoneNeedHelp", messages[1].content);
  EXPECT_EQ("SUPP", messages[2].origin);
  EXPECT_EQ(std::string(53, 'x'), messages[2].content);
}

TEST_F(BoardReceiving, drops_packets_that_hold_no_frame_or_come_from_no_device) {
  expectDropped(bytesOf("x"), Counter::RADIO_BAD_FRAMES);
  expectDropped(bytesOf("////ROMA-I"), Counter::RADIO_BAD_FRAMES);
  expectDropped(bytesOf("////ROMAAB"), Counter::RADIO_BAD_FRAMES);
  expectDropped(bytesOf("////ROMAAI"), Counter::RADIO_BAD_FRAMES);
  expectDropped(plain("////", "++++", "tell;help"), Counter::RADIO_BAD_FRAMES);
  expectDropped(plain("////", "////", "tell;help"), Counter::RADIO_BAD_FRAMES);
}

TEST_F(BoardReceiving, drops_frames_to_reserved_addresses_and_to_the_serial_line) {
  expectDropped(plain("+AAA", "ROMA", "x"), Counter::RADIO_RESERVED);
  expectDropped(plain("+++/", "ROMA", "x"), Counter::RADIO_RESERVED);
  expectDropped(plain("/AAA", "ROMA", "x"), Counter::RADIO_RESERVED);
  expectDropped(plain("++++", "ROMA", "P1"), Counter::RADIO_RESERVED);
}

TEST_F(BoardReceiving, drops_frames_to_others) {
  expectDropped(sealed(KEY, "SUPO", "SUPP", nonce(1, 0), "tell;x"), Counter::RADIO_NOT_FOR_US);
  expectDropped(sealed(KEY, "//RO", "SUPP", nonce(1, 0), "tell;x"), Counter::RADIO_NOT_FOR_US);
}

TEST_F(BoardReceiving, drops_frames_in_its_own_name) {
  expectDropped(plain("////", "SUHO", "tell;x"), Counter::RADIO_OWN);
  expectDropped(sealed(KEY, "SUHO", "SUHO", nonce(1, 0), "tell;x"), Counter::RADIO_OWN);
}

TEST_F(BoardReceiving, drops_sealed_frames_without_a_key) {
  expectDropped(sealed(KEY, "SUHO", "SUAM", nonce(1, 0), "tell;x"), Counter::RADIO_NO_KEY);
  board.request(bytesOf("D//SU"));
  expectDropped(sealed(KEY, "//SU", "SUPP", nonce(1, 0), "tell;x"), Counter::RADIO_NO_KEY);
}

TEST_F(BoardReceiving, drops_plain_short_and_forged_unicasts) {
  expectDropped(plain("SUHO", "SUPP", "tell;help"), Counter::RADIO_BAD_TAG);
  expectDropped(plain("SUHO", "SUPP", ""), Counter::RADIO_BAD_TAG);
  expectDropped(plain("SUHO", "SUPP", std::string(67, 'x')), Counter::RADIO_BAD_TAG);
  expectDropped(sealed(OTHER_KEY, "SUHO", "SUPP", nonce(1, 0), "tell;x"), Counter::RADIO_BAD_TAG);
}

TEST_F(BoardReceiving, drops_and_counts_a_sealed_frame_with_any_bit_changed) {
  const Bytes frame = sealed(KEY, "SUHO", "SUPP", nonce(1, 0), "tell;ambulanceIsComing");
  uint32_t expected = 0;
  for (size_t bit = 0; bit < frame.size() * 8; bit++) {
    Bytes changed = frame;
    changed[bit / 8] = static_cast<uint8_t>(changed[bit / 8] ^ 1 << bit % 8);
    board.receive(changed);
    expected++;
  }
  EXPECT_TRUE(board.messages().empty());
  uint32_t dropped = 0;
  for (Counter counter : {Counter::RADIO_BAD_FRAMES, Counter::RADIO_RESERVED, Counter::RADIO_NOT_FOR_US,
                          Counter::RADIO_OWN, Counter::RADIO_NO_KEY, Counter::RADIO_BAD_TAG}) {
    dropped += board.counter(counter);
  }
  EXPECT_EQ(expected, dropped);
  board.receive(frame);
  EXPECT_EQ(1u, board.messages().size()) << "none of them has used up the nonce";
}

TEST_F(BoardReceiving, drops_the_same_sealed_frame_again_and_any_older_one) {
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(5, 5), "tell;x"));
  board.pollTaking(0);
  expectDropped(sealed(KEY, "SUHO", "SUPP", nonce(5, 5), "tell;x"), Counter::RADIO_REPEATS);
  expectDropped(sealed(KEY, "SUHO", "SUPP", nonce(5, 4), "tell;y"), Counter::RADIO_REPLAYED);
  expectDropped(sealed(KEY, "SUHO", "SUPP", nonce(4, 9), "tell;y"), Counter::RADIO_REPLAYED);
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(6, 0), "tell;x"));
  EXPECT_EQ(1u, board.messages().size());
}

TEST_F(BoardReceiving, knows_the_nonces_of_each_origin_in_a_group) {
  board.receive(sealed(KEY, "//SU", "SUPO", nonce(5, 5), "tell;x"));
  board.receive(sealed(KEY, "//SU", "SUAM", nonce(1, 1), "tell;x"));
  EXPECT_EQ(2u, board.messages().size());
}

TEST_F(BoardReceiving, drops_sealed_frames_of_origins_that_it_cannot_remember) {
  for (int i = 0; i < javinolib::config::REPLAY_ENTRIES - 1; i++) {  // one place is kept for SUPP
    board.receive(sealed(KEY, "//SU", "AAA" + std::string(1, static_cast<char>('A' + i)), nonce(1, 0), "tell;x"));
    board.pollTaking(static_cast<uint8_t>(i));
  }
  expectDropped(sealed(KEY, "//SU", "ZZZZ", nonce(1, 0), "tell;x"), Counter::RADIO_REPLAY_FULL);
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 0), "tell;pair"));
  EXPECT_EQ("tell;pair", board.messages().at(0).content);
}

TEST_F(BoardReceiving, a_new_key_begins_with_no_nonce_remembered) {
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(5, 5), "tell;x"));
  board.setKey("SUPP", OTHER_KEY);
  board.receive(sealed(OTHER_KEY, "SUHO", "SUPP", nonce(1, 0), "tell;x"));
  EXPECT_EQ(2u, board.messages().size());
}

TEST_F(BoardReceiving, setting_the_same_key_again_forgets_no_nonce) {
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(5, 5), "tell;x"));
  board.setKey("SUPP", KEY);
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(5, 5), "tell;x"));
  EXPECT_EQ(1u, board.messages().size());
}

TEST_F(BoardReceiving, keeps_messages_until_they_are_taken_and_counts_what_finds_no_room) {
  const int room = javinolib::config::RECEIVE_BYTES / (2 + 15 + 60);
  for (int i = 0; i < room + 2; i++) board.receive(plain("////", "ROMA", std::string(60, static_cast<char>('a' + i))));
  EXPECT_EQ(2u, board.counter(Counter::RADIO_QUEUE_FULL));
  EXPECT_EQ(0, board.messages().front().number);
  EXPECT_EQ(0, board.messages().front().number) << "what is not taken comes again";
  board.pollTaking(1);
  EXPECT_EQ(std::string(60, 'c'), board.messages().front().content);
  EXPECT_EQ(2, board.messages().front().number);
  board.pollTaking(1);
  EXPECT_EQ(room - 2, waiting(2)) << "an old number takes nothing more";
}

TEST_F(BoardReceiving, a_sealed_message_that_found_no_room_is_good_once_there_is_room) {
  const int room = javinolib::config::RECEIVE_BYTES / (2 + 15 + 60);
  for (int i = 0; i < room; i++) board.receive(plain("////", "ROMA", std::string(60, static_cast<char>('a' + i))));
  const Bytes frame = sealed(KEY, "SUHO", "SUPP", nonce(5, 5), std::string(53, 'y'));
  board.receive(frame);
  EXPECT_EQ(1u, board.counter(Counter::RADIO_QUEUE_FULL));
  board.pollTaking(static_cast<uint8_t>(room - 1));
  board.receive(frame);
  EXPECT_EQ(std::string(53, 'y'), board.messages().at(0).content);
}

TEST_F(BoardReceiving, numbers_run_around_after_255) {
  for (int i = 0; i < 600; i++) {
    board.receive(plain("////", "ROMA", "tell;m" + std::to_string(i)));
    const std::vector<PolledMessage> messages = board.messages();
    ASSERT_EQ(1u, messages.size());
    ASSERT_EQ(i % 256, messages[0].number);
    board.pollTaking(messages[0].number);
  }
}

TEST(RadioBoard, without_an_id_hears_broadcasts_only) {
  TestBoard board;
  board.start();
  board.setKey("//++", KEY);
  board.receive(plain("////", "ROMA", "tell;help"));
  board.receive(sealed(KEY, "//++", "SUPP", nonce(1, 0), "tell;x"));
  EXPECT_EQ(1u, board.messages().size());
  EXPECT_EQ(1u, board.counter(Counter::RADIO_NOT_FOR_US));
}

TEST_F(BoardReceiving, hostile_packets_never_break_it_and_deliver_broadcasts_only) {
  RandomBytes random(13);
  for (int i = 0; i < 5000; i++) {
    Bytes packet = random.bytes(1 + random.number(77));
    if (random.number(2) == 0) packet = plain("SUHO", "SUPP", textOf(random.bytes(random.number(68))));
    board.receive(packet);
    for (const PolledMessage &message : board.messages()) {
      ASSERT_EQ("////", message.destination);
      board.pollTaking(message.number);
    }
  }
}
