#include <Arduino.h>
#include <gtest/gtest.h>

#include "support/Reference.h"
#include "support/TestBoard.h"

namespace {

void manyPercepts(javino::Percepts &percepts) {
  for (int i = 0; i < 30; i++) percepts.add(F("proximity"), i);
}

class BoardPolling : public testing::Test {
 protected:
  BoardPolling() { board.start("ROMA"); }

  TestBoard board;
};

}  // namespace

TEST_F(BoardPolling, writes_transmissions_then_percepts_then_messages) {
  board.board->onPercepts([](javino::Percepts &percepts) { percepts.add(F("dark")); });
  board.transmit("////", "ROMA", "tell;x");
  board.sendNext();
  board.receive(plain("////", "SUPO", "tell;y"));
  const PollReply reply = board.poll(true);
  ASSERT_EQ(3u, reply.records.size());
  EXPECT_EQ('T', reply.records[0].type);
  EXPECT_EQ('P', reply.records[1].type);
  EXPECT_EQ('M', reply.records[2].type);
  EXPECT_FALSE(reply.more);
  EXPECT_FALSE(reply.leftOut);
}

TEST_F(BoardPolling, says_that_more_waits_where_messages_did_not_fit) {
  board.board->onPercepts(manyPercepts);
  for (char name : {'x', 'y', 'z'}) board.receive(plain("////", "SUPO", std::string(67, name)));
  const PollReply first = board.poll(true);
  EXPECT_TRUE(first.more);
  const PollReply second = board.poll(false);
  EXPECT_FALSE(second.more);
  EXPECT_EQ(3u, second.records.size());
}

TEST_F(BoardPolling, says_that_the_air_is_active_while_a_carrier_is_heard_or_a_message_is_under_way) {
  EXPECT_FALSE(board.poll().airActive);
  board.radio.heard = true;
  board.pass(1);
  EXPECT_TRUE(board.poll().airActive);
  board.radio.heard = false;
  board.pass(1);
  EXPECT_FALSE(board.poll().airActive);
  board.transmit("////", "ROMA", "tell;x");
  EXPECT_TRUE(board.poll().airActive);
  board.sendNext();
  EXPECT_FALSE(board.poll().airActive);
}

TEST_F(BoardPolling, a_repeated_poll_brings_the_same_again) {
  board.transmit("////", "ROMA", "tell;x");
  board.sendNext();
  const Bytes poll = reference::packet(200, reference::frame("++++", "++++", {'P', 0}));
  const std::vector<Bytes> first = board.sendRaw(poll);
  EXPECT_EQ(first, board.sendRaw(poll));
}

TEST_F(BoardPolling, statistics_tell_all_counters_in_order) {
  board.radio.counts = {0x01020304, 6, 7, 17, 28};
  const Bytes body = board.request('S').body;
  ASSERT_EQ(javino::Counters::COUNT * 5u, body.size());
  for (size_t i = 0; i < javino::Counters::COUNT; i++) EXPECT_EQ(i + 1, body[i * 5]);
  EXPECT_EQ(0x01020304u, board.counter(javino::Counter::RADIO_RECEIVED));
  EXPECT_EQ(6u, board.counter(javino::Counter::RADIO_DAMAGED));
  EXPECT_EQ(7u, board.counter(javino::Counter::RADIO_MISSED));
  EXPECT_EQ(17u, board.counter(javino::Counter::RADIO_SENT));
  EXPECT_EQ(28u, board.counter(javino::Counter::RADIO_MENDED));
  board.reboot();
  board.hello();
  EXPECT_EQ(2u, board.counter(javino::Counter::SERIAL_REQUESTS)) << "all start at 0 at each boot";
}

TEST(Counters, stop_at_their_greatest_value) {
  javino::Counters counters;
  counters.set(javino::Counter::SERIAL_REPEATS, 0xFFFFFFFE);
  for (int i = 0; i < 3; i++) counters.count(javino::Counter::SERIAL_REPEATS);
  EXPECT_EQ(0xFFFFFFFFu, counters.value(javino::Counter::SERIAL_REPEATS));
}
