#include <gtest/gtest.h>

#include "support/Keys.h"
#include "support/Fragments.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

const uint8_t PLACES = javinolib::config::SESSION_KEYS;

Bytes keyOf(uint8_t number) { return Bytes(16, number); }

// SUAA, SUAB, …
std::string device(int number) { return std::string("SUA") + static_cast<char>('A' + number); }

// A board SUHO without any key.
class BoardSessionKeys : public testing::Test {
 protected:
  BoardSessionKeys() {
    board.start("SUHO");
    written = board.eeprom.writes();
  }

  Status set(const std::string &device, const Bytes &key) { return board.request('V', bytesOf(device) + key).status; }

  // The addresses, roles and nothing else of the board's keys.
  std::string list() {
    std::string list;
    const Bytes body = board.request('L').body;
    for (size_t at = 0; at < body.size(); at += 8) {
      list += std::string(body.begin() + at, body.begin() + at + 4) + std::to_string(body[at + 4]) + " ";
    }
    return list;
  }

  // Whether a frame from a device is accepted; its host takes it.
  bool accepts(const std::string &device, const Bytes &key, uint8_t counter) {
    board.receive(sealed(key, "SUHO", device, nonce(1, counter), "tell;x"));
    const std::vector<PolledMessage> messages = board.messages();
    if (!messages.empty()) board.pollTaking(messages.back().number);
    board.passSending(50);
    return !messages.empty();
  }

  // The records N that wait: those that are told are forgotten.
  std::vector<std::string> withoutKey() { return board.poll().texts('N'); }

  void fill() {
    for (uint8_t i = 0; i < PLACES; i++) ASSERT_EQ(Status::OK, set(device(i), keyOf(i)));
  }

  TestBoard board;
  int written;
};

}  // namespace

TEST_F(BoardSessionKeys, seal_open_and_acknowledge_and_write_nothing) {
  EXPECT_EQ(Status::NO_KEY, board.transmit("SUPP", "SUHO", "tell;x").status);
  EXPECT_EQ(Status::OK, set("SUPP", KEY));
  EXPECT_EQ("SUPP3 ", list());
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), "tell;hello"));
  const std::vector<PolledMessage> messages = board.messages();
  ASSERT_EQ(1u, messages.size());
  EXPECT_EQ("tell;hello", messages[0].content);
  board.pollTaking(messages[0].number);
  EXPECT_EQ(acknowledgement(KEY, "SUPP", "SUHO", nonce(1, 1), 6), board.sendNext());

  EXPECT_EQ(Status::OK, board.transmit("SUPP", "SUHO", "tell;answer").status);
  const Bytes sent = board.sendNext();
  const Bytes itsNonce(sent.begin() + 10, sent.begin() + 16);
  EXPECT_EQ(sealed(KEY, "SUPP", "SUHO", itsNonce, "tell;answer"), sent);
  board.receive(acknowledgement(KEY, "SUHO", "SUPP", itsNonce, 6));
  EXPECT_EQ(std::vector<std::string>{std::string("\0\1", 2)}, board.poll().texts('T'));
  EXPECT_EQ(written, board.eeprom.writes());
}

TEST_F(BoardSessionKeys, are_gone_at_each_boot_also_where_the_ram_is_kept) {
  ASSERT_EQ(Status::OK, set("SUPP", KEY));
  ASSERT_TRUE(accepts("SUPP", KEY, 1));
  board.start();
  EXPECT_EQ("", list());
  EXPECT_EQ(Status::NO_KEY, board.transmit("SUPP", "SUHO", "tell;x").status);
  EXPECT_FALSE(accepts("SUPP", KEY, 2));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_NO_KEY));
  ASSERT_EQ(Status::OK, set("SUPP", OTHER_KEY)) << "agreed on anew";
  EXPECT_TRUE(accepts("SUPP", OTHER_KEY, 1)) << "nothing is left of what came under the one before";
}

// The boot epoch changes in each boot; all else stays.
TEST_F(BoardSessionKeys, leave_no_trace_in_eeprom) {
  const Bytes before = board.eeprom.content();
  for (uint8_t round = 0; round < 40; round++) {
    for (uint8_t i = 0; i < PLACES + 2; i++) ASSERT_EQ(Status::OK, set(device(i), Bytes(15, round) + Bytes{i}));
    for (uint8_t counter = 1; counter < 60; counter++) {
      ASSERT_TRUE(accepts(device(PLACES + 1), Bytes(15, round) + Bytes{static_cast<uint8_t>(PLACES + 1)}, counter));
    }
    ASSERT_EQ(Status::OK, board.request('D', bytesOf(device(PLACES + 1))).status);
  }
  EXPECT_EQ(before, board.eeprom.content());
  EXPECT_EQ(written, board.eeprom.writes());
}

TEST_F(BoardSessionKeys, refuse_replays_while_the_key_is_there) {
  ASSERT_EQ(Status::OK, set("SUPP", KEY));
  ASSERT_TRUE(accepts("SUPP", KEY, 1));
  ASSERT_TRUE(accepts("SUPP", KEY, 7));
  EXPECT_FALSE(accepts("SUPP", KEY, 1));
  EXPECT_FALSE(accepts("SUPP", KEY, 7));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_REPLAYED));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_REPEATS)) << "which is acknowledged again";
  EXPECT_EQ(Status::OK, set("SUPP", KEY)) << "the same again";
  EXPECT_FALSE(accepts("SUPP", KEY, 6)) << "without any effect";
  EXPECT_TRUE(accepts("SUPP", KEY, 8));
}

TEST_F(BoardSessionKeys, are_never_set_a_second_time) {
  ASSERT_EQ(Status::OK, set("SUPP", KEY));
  ASSERT_TRUE(accepts("SUPP", KEY, 1));
  ASSERT_EQ(Status::OK, set("SUPP", OTHER_KEY));
  EXPECT_FALSE(accepts("SUPP", KEY, 2)) << "the key before is gone";
  EXPECT_TRUE(accepts("SUPP", OTHER_KEY, 1)) << "and what came under it is forgotten";
  EXPECT_EQ(Status::BAD_ARGUMENT, set("SUPP", KEY)) << "else what came under it could come again";
  ASSERT_EQ(Status::OK, board.request('D', bytesOf("SUPP")).status);
  EXPECT_EQ(Status::NO_KEY, board.request('D', bytesOf("SUPP")).status);
  EXPECT_EQ(Status::BAD_ARGUMENT, set("SUPP", OTHER_KEY));
  EXPECT_EQ(Status::BAD_ARGUMENT, board.setKey("SUPP", OTHER_KEY).status) << "nor in EEPROM";
  EXPECT_EQ(Status::BAD_ARGUMENT, set("SUPO", OTHER_KEY)) << "nor for another device";
  EXPECT_EQ("", list());
}

TEST_F(BoardSessionKeys, are_remembered_when_others_have_taken_their_places) {
  fill();
  for (uint8_t i = 0; i < PLACES; i++) ASSERT_EQ(Status::OK, set(device(i), keyOf(static_cast<uint8_t>(100 + i))));
  for (uint8_t i = 0; i < PLACES; i++) EXPECT_EQ(Status::BAD_ARGUMENT, set(device(i), keyOf(i))) << int(i);
}

TEST_F(BoardSessionKeys, give_way_to_keys_in_eeprom_and_never_take_their_place) {
  ASSERT_EQ(Status::OK, board.setKey("SUPP", KEY).status);
  EXPECT_EQ(Status::HAS_KEY, set("SUPP", OTHER_KEY));
  EXPECT_EQ(Status::HAS_KEY, set("SUPP", KEY));
  ASSERT_EQ(Status::OK, board.request('N', bytesOf("SUPP") + THIRD_KEY).status);
  EXPECT_EQ(Status::HAS_KEY, set("SUPP", OTHER_KEY));
  EXPECT_EQ("SUPP0 SUPP2 ", list());

  ASSERT_EQ(Status::OK, set("SUPO", OTHER_KEY));
  ASSERT_TRUE(accepts("SUPO", OTHER_KEY, 9));
  ASSERT_EQ(Status::OK, board.setKey("SUPO", keyOf(1)).status);
  EXPECT_EQ("SUPP0 SUPP2 SUPO0 ", list());
  EXPECT_FALSE(accepts("SUPO", OTHER_KEY, 10));
  EXPECT_TRUE(accepts("SUPO", keyOf(1), 1));
}

// A refused key must not cost the session key.
TEST_F(BoardSessionKeys, stay_where_the_key_store_is_full) {
  for (int i = 0; i < javinolib::config::KEYS; i++) {
    ASSERT_EQ(Status::OK, board.setKey(std::string("ROA") + static_cast<char>('A' + i), KEY).status);
  }
  ASSERT_EQ(Status::OK, set("SUPP", OTHER_KEY));
  EXPECT_EQ(Status::STORE_FULL, board.setKey("SUPP", THIRD_KEY).status);
  EXPECT_TRUE(accepts("SUPP", OTHER_KEY, 1));
}

// Each pair's nonce has its place, and so has each session's.
TEST_F(BoardSessionKeys, have_places_of_their_own_in_the_replay_memory) {
  ASSERT_EQ(Status::OK, board.setKey("//SU", KEY).status);
  for (uint8_t i = 0; i < javinolib::config::REPLAY_ENTRIES; i++) {
    board.receive(sealed(KEY, "//SU", std::string("ROA") + static_cast<char>('A' + i), nonce(1, 1), "tell;x"));
    const std::vector<PolledMessage> messages = board.messages();
    ASSERT_EQ(1u, messages.size());
    board.pollTaking(messages[0].number);
  }
  board.receive(sealed(KEY, "//SU", "ROBA", nonce(1, 1), "tell;x"));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_REPLAY_FULL)) << "the group cannot take them";
  fill();
  EXPECT_EQ(Status::STORE_FULL, board.setKey(device(0), THIRD_KEY).status) << "a pair in EEPROM cannot either";
  for (uint8_t i = 0; i < PLACES; i++) EXPECT_TRUE(accepts(device(i), keyOf(i), 1)) << int(i);
}

TEST_F(BoardSessionKeys, cannot_be_renewed) {
  ASSERT_EQ(Status::OK, set("SUPP", KEY));
  EXPECT_EQ(Status::NO_KEY, board.request('N', bytesOf("SUPP") + OTHER_KEY).status);
  EXPECT_EQ(Status::NO_KEY, board.request('U', bytesOf("SUPP")).status);
  EXPECT_EQ(Status::NO_KEY, board.request('F', bytesOf("SUPP")).status);
  EXPECT_TRUE(accepts("SUPP", KEY, 1));
}

TEST_F(BoardSessionKeys, are_of_devices_only) {
  for (const char *address : {"//SU", "////", "++++", "+FAA", "+KAA", "self"}) {
    EXPECT_EQ(Status::BAD_ARGUMENT, set(address, KEY)) << address;
  }
  for (size_t length : {0u, 1u, 15u, 17u}) EXPECT_EQ(Status::BAD_ARGUMENT, set("SUPP", Bytes(length, 1))) << length;
}

TEST_F(BoardSessionKeys, make_room_where_used_least_recently) {
  fill();
  ASSERT_TRUE(accepts(device(0), keyOf(0), 1));
  ASSERT_EQ(Status::OK, board.transmit(device(1), "SUHO", "tell;x").status);
  const Bytes sent = board.sendNext();
  board.receive(acknowledgement(keyOf(1), "SUHO", device(1), Bytes(sent.begin() + 10, sent.begin() + 16), 6));
  EXPECT_FALSE(accepts(device(2), KEY, 1)) << "a forgery is no use";
  ASSERT_EQ(Status::OK, set("ROMA", KEY));
  EXPECT_FALSE(accepts(device(2), keyOf(2), 1));
  ASSERT_EQ(Status::OK, set("ROMB", OTHER_KEY));
  EXPECT_FALSE(accepts(device(3), keyOf(3), 1));
  for (int kept : {0, 1, 4, 5, 6, 7}) EXPECT_TRUE(accepts(device(kept), keyOf(static_cast<uint8_t>(kept)), 2)) << kept;
  EXPECT_TRUE(accepts("ROMA", KEY, 1));
  EXPECT_TRUE(accepts("ROMB", OTHER_KEY, 1));
}

TEST_F(BoardSessionKeys, make_no_room_while_a_place_is_free) {
  fill();
  ASSERT_EQ(Status::OK, board.request('D', bytesOf(device(PLACES - 1))).status);
  ASSERT_EQ(Status::OK, set("ROMA", KEY));
  EXPECT_TRUE(accepts("ROMA", KEY, 1));
  for (uint8_t i = 0; i + 1 < PLACES; i++) EXPECT_TRUE(accepts(device(i), keyOf(i), 1)) << int(i);
}

TEST_F(BoardSessionKeys, make_room_last_where_something_is_to_be_sent) {
  fill();
  for (uint8_t i = 0; i + 1 < PLACES; i++) {
    ASSERT_EQ(Status::OK, board.transmit(device(i), "SUHO", "tell;x").status) << int(i);
  }
  ASSERT_EQ(Status::OK, set("ROMA", KEY));
  EXPECT_FALSE(accepts(device(PLACES - 1), keyOf(PLACES - 1), 1)) << "though it was set last";
  EXPECT_TRUE(accepts(device(0), keyOf(0), 1));
}

TEST_F(BoardSessionKeys, that_made_room_leave_their_messages_undelivered) {
  fill();
  for (uint8_t i = 0; i < PLACES; i++) {
    ASSERT_EQ(Status::OK, board.transmit(device(i), "SUHO", "tell;x").status) << int(i);
  }
  ASSERT_EQ(Status::OK, set("ROMA", KEY)) << "some must go";
  EXPECT_EQ(6u * PLACES, list().size());
  std::vector<std::string> ends;
  for (int left = 600; ends.size() < PLACES && left != 0; left--) {
    board.passSending(100);
    for (const std::string &end : board.poll().texts('T')) ends.push_back(end);
  }
  ASSERT_EQ(static_cast<size_t>(PLACES), ends.size());
  for (const std::string &end : ends) EXPECT_EQ(2, end[1]);
}

// A message sealed under one key must not be acknowledged under the next one in its place.
TEST_F(BoardSessionKeys, that_are_replaced_acknowledge_no_more) {
  ASSERT_EQ(Status::OK, set("SUPP", KEY));
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 200), "tell;x"));
  const std::vector<PolledMessage> messages = board.messages();
  ASSERT_EQ(1u, messages.size());
  ASSERT_EQ(Status::OK, set("SUPP", OTHER_KEY));
  board.pollTaking(messages[0].number);
  board.passSending(100);
  EXPECT_TRUE(board.radio.sent.empty());
  EXPECT_TRUE(accepts("SUPP", OTHER_KEY, 1)) << "its nonce is not taken for one of the new key";
}

// Nothing can acknowledge it any more, and its host sends it again.
TEST_F(BoardSessionKeys, that_are_replaced_or_deleted_end_their_messages_at_once) {
  for (const bool deleted : {false, true}) {
    ASSERT_EQ(Status::OK, set("SUPP", Bytes(16, deleted ? 1 : 3)));
    ASSERT_EQ(Status::OK, board.transmit("SUPP", "SUHO", "tell;x").status);
    board.sendNext();
    EXPECT_TRUE(board.poll().texts('T').empty());
    ASSERT_EQ(Status::OK, deleted ? board.request('D', bytesOf("SUPP")).status : set("SUPP", Bytes(16, 2)));
    const std::vector<std::string> ends = board.poll().texts('T');
    ASSERT_EQ(1u, ends.size());
    EXPECT_EQ(2, ends[0][1]);
    EXPECT_EQ(1u + deleted, board.counter(Counter::RADIO_UNDELIVERED));
  }
  ASSERT_EQ(Status::OK, set("SUPP", KEY));
  ASSERT_EQ(Status::OK, board.transmit("SUPP", "SUHO", "tell;y").status);
  const Bytes sent = board.sendNext();
  EXPECT_EQ(sealed(KEY, "SUPP", "SUHO", Bytes(sent.begin() + 10, sent.begin() + 16), "tell;y"), sent);
}

TEST_F(BoardSessionKeys, answer_a_repeated_request_from_memory) {
  const Bytes frame = reference::frame("++++", "++++", bytesOf("VSUPP") + KEY);
  const Bytes packet = reference::packet(77, frame);
  const std::vector<Bytes> first = board.sendRaw(packet);
  ASSERT_EQ(1u, first.size());
  EXPECT_EQ(first, board.sendRaw(packet));
  EXPECT_TRUE(accepts("SUPP", KEY, 1));
}

TEST_F(BoardSessionKeys, without_one_the_host_is_told_once_for_each_origin) {
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), "tell;x"));
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), "tell;x"));
  board.receive(sealed(KEY, "//SU", "SUPO", nonce(1, 1), "tell;x"));
  const std::vector<std::string> both = {"SUHOSUPP", "//SUSUPO"};
  EXPECT_EQ(both, withoutKey());
  EXPECT_EQ(std::vector<std::string>(), withoutKey());
  EXPECT_EQ(3u, board.counter(Counter::RADIO_NO_KEY));
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), "tell;x"));
  EXPECT_EQ(std::vector<std::string>{"SUHOSUPP"}, withoutKey());
}

TEST_F(BoardSessionKeys, without_one_a_poll_that_is_held_is_answered) {
  board.hold(0, 2000);
  board.pass(10);
  EXPECT_FALSE(board.replies());
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), "tell;x"));
  board.pass(1);
  EXPECT_EQ(std::vector<std::string>{"SUHOSUPP"}, board.takeReply().texts('N'));
}

TEST_F(BoardSessionKeys, without_one_what_was_told_is_told_again_if_the_reply_is_lost) {
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), "tell;x"));
  EXPECT_EQ(std::vector<std::string>{"SUHOSUPP"}, withoutKey());
  board.hold(4, 0);
  EXPECT_EQ(std::vector<std::string>{"SUHOSUPP"}, board.takeReply().texts('N'));
  board.hello();
  EXPECT_EQ(std::vector<std::string>{"SUHOSUPP"}, withoutKey()) << "the host may be another one";
  EXPECT_EQ(std::vector<std::string>(), withoutKey());
}

TEST_F(BoardSessionKeys, without_one_a_first_fragment_is_told_too) {
  const std::vector<Bytes> fragments = cut(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), std::string(90, 'x')), 5);
  board.receive(fragments[1]);
  EXPECT_EQ(std::vector<std::string>(), withoutKey());
  board.receive(fragments[0]);
  EXPECT_EQ(std::vector<std::string>{"SUHOSUPP"}, withoutKey());
}

TEST_F(BoardSessionKeys, without_one_nothing_is_told_of_what_is_not_for_the_board) {
  board.receive(sealed(KEY, "SUPP", "SUPO", nonce(1, 1), "tell;x"));
  board.receive(sealed(KEY, "//RO", "SUPO", nonce(1, 1), "tell;x"));
  board.receive(sealed(KEY, "SUHO", "SUHO", nonce(1, 1), "tell;x"));
  board.receive(plain("////", "SUPO", "tell;x"));
  board.request('R', {0});
  board.receive(sealed(KEY, "SUHO", "SUPO", nonce(1, 1), "tell;x"));
  ASSERT_EQ(Status::OK, set("SUPP", KEY));
  board.request('R', {1});
  board.receive(sealed(OTHER_KEY, "SUHO", "SUPP", nonce(1, 1), "tell;x"));
  EXPECT_EQ(1u, board.counter(Counter::RADIO_BAD_TAG)) << "it has a key, though another";
  EXPECT_EQ(std::vector<std::string>(), withoutKey());
}

// A flood of forged origins takes neither room nor turn from messages and outcomes, and writes nothing.
TEST_F(BoardSessionKeys, without_one_a_flood_crowds_out_nothing) {
  ASSERT_EQ(Status::OK, set("SUPP", KEY));
  ASSERT_EQ(Status::OK, board.transmit("////", "SUHO", "tell;x").status);
  board.sendNext();
  for (uint32_t origin = 0; origin < 1000; origin++) {
    Bytes text(4);
    javinolib::Address(0x100000 + origin).write(text.data());
    board.receive(sealed(OTHER_KEY, "SUHO", textOf(text), nonce(1, 1), "tell;x"));
  }
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(1, 1), "tell;x"));
  const PollReply reply = board.poll();
  std::string types;
  for (const PollRecord &record : reply.records) types += record.type;
  EXPECT_EQ("TMNNNN", types);
  EXPECT_FALSE(reply.more);
  EXPECT_EQ(1000u, board.counter(Counter::RADIO_NO_KEY));
  EXPECT_EQ(0u, board.counter(Counter::RADIO_QUEUE_FULL));
  EXPECT_EQ(written, board.eeprom.writes());
}
