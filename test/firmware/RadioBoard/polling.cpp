#include <Arduino.h>
#include <gtest/gtest.h>

#include "radio/AskHardware.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Status;

namespace {

// The readings of the sensors, and how often they were read.
int shown;
int readings;

// The hardware's word, in bits of a reply's flags.
uint8_t takenTimer;

void readLevel(javinolib::Percepts &percepts) {
  readings++;
  percepts.add(F("level"), shown);
}

class BoardPolling : public testing::Test {
 protected:
  BoardPolling() {
    shown = 0;
    readings = 0;
    takenTimer = 0;
    board.start("ROMA");
    board.board->poll().setSource(readLevel);
  }

  // Takes the reading that a poll must have brought.
  void expectReading(int expected) {
    const PollReply reply = board.takeReply();
    EXPECT_TRUE(reply.reading);
    EXPECT_EQ(std::vector<std::string>{"level(" + std::to_string(expected) + ")"}, reply.texts('P'));
    EXPECT_EQ(1u, reply.records.size());
  }

  // Takes the reply of a poll, which must be empty.
  void expectNothing() {
    const PollReply reply = board.takeReply();
    EXPECT_FALSE(reply.reading);
    EXPECT_FALSE(reply.more);
    EXPECT_TRUE(reply.records.empty());
  }

  // How many milliseconds pass until the board replies.
  uint32_t untilReply() {
    uint32_t passed = 0;
    for (; !board.replies() && passed < 100000; passed++) board.pass(1);
    return passed;
  }

  // The host has a reading.
  void tellOne() {
    board.hold(PERCEPTS, 0);
    expectReading(shown);
  }

  TestBoard board;
};

}  // namespace

uint8_t javinolib::askhardware::takenTimer() { return ::takenTimer; }

TEST_F(BoardPolling, writes_transmissions_then_messages_and_a_reading_in_a_reply_of_its_own) {
  board.transmit("////", "ROMA", "tell;x");
  board.sendNext();
  board.receive(plain("////", "SUPO", "tell;y"));
  board.hold(PERCEPTS_NOW, 0);
  const PollReply reply = board.takeReply();
  ASSERT_EQ(2u, reply.records.size());
  EXPECT_EQ('T', reply.records[0].type);
  EXPECT_EQ('M', reply.records[1].type);
  EXPECT_FALSE(reply.more);
  EXPECT_FALSE(reply.leftOut);
  EXPECT_FALSE(reply.reading);
  EXPECT_EQ(0, readings) << "no sensor is read while something else is to be told";
  board.pollTaking(0);
  board.hold(PERCEPTS_NOW, 0);
  expectReading(0);
}

TEST_F(BoardPolling, says_that_more_waits_where_messages_did_not_fit) {
  board.transmit("////", "ROMA", "tell;x");
  board.sendNext();
  for (const char *content : {"w", "x", "y", "z"}) {
    board.receive(plain("////", "SUPO", content + std::string(66, 'm')));
    board.receive(plain("////", "SUHO", content + std::string(66, 'm')));
  }
  const PollReply first = board.poll();
  EXPECT_TRUE(first.more);
  EXPECT_EQ(6u, first.texts('M').size());
  const PollReply second = board.pollTaking(5);
  EXPECT_FALSE(second.more);
  EXPECT_EQ(1u, second.texts('M').size());
}

TEST_F(BoardPolling, holds_its_reply_for_the_time_that_the_host_gives) {
  for (const uint16_t hold : {1, 20, 1000, 65535}) {
    board.hold(NO_PERCEPTS, hold);
    EXPECT_EQ(hold, untilReply());
    expectNothing();
  }
  board.hold(NO_PERCEPTS, 0);
  expectNothing();
  EXPECT_EQ(0, readings);
}

TEST_F(BoardPolling, gives_one_reply_only_after_a_hold) {
  board.hold(NO_PERCEPTS, 10);
  board.pass(10);
  expectNothing();
  board.receive(plain("////", "SUPO", "tell;x"));
  board.pass(5000);
  EXPECT_FALSE(board.replies());
}

TEST_F(BoardPolling, tells_a_held_poll_a_message_and_an_outcome_at_once) {
  board.hold(PERCEPTS, 60000);
  expectReading(0);
  board.hold(PERCEPTS, 60000);
  board.receive(plain("////", "SUPO", "tell;x"));
  EXPECT_FALSE(board.board->isIdle()) << "the CPU must not sleep on what it can tell";
  board.board->run();
  EXPECT_EQ(1u, board.takeReply().texts('M').size());
  EXPECT_TRUE(board.board->isIdle());
  board.pollTaking(0);
  board.transmit("////", "ROMA", "tell;x");
  board.hold(NO_PERCEPTS, 60000);
  board.sendNext();
  board.board->run();
  EXPECT_EQ(1u, board.takeReply().texts('T').size());
}

TEST_F(BoardPolling, a_byte_from_the_host_ends_a_hold_without_a_reading) {
  tellOne();
  board.hold(PERCEPTS, 60000);
  const int before = readings;
  shown = 1;
  board.port.arrive({0});
  EXPECT_FALSE(board.board->isIdle());
  board.clock.millis += 20;
  board.board->run();
  expectNothing();
  EXPECT_EQ(before, readings) << "an action must not wait for a sensor";
}

TEST_F(BoardPolling, a_byte_ends_a_hold_whenever_it_comes) {
  for (int look = 1; look < 6; look++) {
    board.hold(NO_PERCEPTS, 60000);
    board.port.arriveAtLook(look, {0});
    for (int i = 0; i < look + 1; i++) board.board->run();
    expectNothing();
  }
}

TEST_F(BoardPolling, a_request_after_the_byte_that_ends_a_hold_is_performed_at_once) {
  board.board->actions().add(F("raise"), [](const javinolib::Arguments &) {
    shown++;
    return true;
  });
  tellOne();
  board.hold(PERCEPTS, 60000);
  const Bytes request = reference::packet(200, reference::frame("++++", "++++", bytesOf("Araise")));
  const std::vector<Bytes> replies = board.sendRaw(Bytes{0} + request);
  ASSERT_EQ(2u, replies.size());
  EXPECT_EQ(200, reference::cobsDecoded(replies[1])[0]);
  EXPECT_EQ(1, shown);
}

TEST_F(BoardPolling, requests_behind_a_poll_end_its_hold) {
  const Bytes poll = reference::packet(200, reference::frame("++++", "++++", {'P', 0, 0xFF, 0xFF, 0, 0, 0}));
  const Bytes other = reference::packet(201, reference::frame("++++", "++++", {'L'}));
  const std::vector<Bytes> replies = board.sendRaw(poll + other);
  ASSERT_EQ(2u, replies.size());
  EXPECT_EQ(200, reference::cobsDecoded(replies[0])[0]);
  EXPECT_EQ(201, reference::cobsDecoded(replies[1])[0]);
}

TEST_F(BoardPolling, lets_the_cpu_sleep_while_a_poll_is_held) {
  board.hold(PERCEPTS, 60000);
  expectReading(0);
  board.hold(PERCEPTS, 60000);
  EXPECT_TRUE(board.board->isIdle());
}

TEST_F(BoardPolling, tells_a_reading_when_it_differs_from_the_last_one_told) {
  board.hold(PERCEPTS, 60000);
  expectReading(0);
  board.hold(PERCEPTS, 60000);
  board.pass(5000);
  EXPECT_FALSE(board.replies());
  shown = 7;
  EXPECT_LE(untilReply(), 20u);
  expectReading(7);
  board.hold(PERCEPTS, 60000);
  board.pass(5000);
  EXPECT_FALSE(board.replies());
}

TEST_F(BoardPolling, tells_each_change_of_a_single_byte_and_no_reading_twice) {
  static std::string text;
  for (size_t length = 1; length < 12; length++) {
    text.assign(length, 'a');
    board.board->poll().setSource([](javinolib::Percepts &percepts) { percepts.literal(text.c_str()); });
    board.poll(true);
    for (size_t at = 0; at < length; at++) {
      text[at] = 'b';
      board.hold(PERCEPTS, 0);
      ASSERT_EQ(std::vector<std::string>{text}, board.takeReply().texts('P')) << at;
      board.hello();  // its longer reply leaves other bytes in the buffer
      board.poll(true);
      board.request('S');
      board.hold(PERCEPTS, 0);
      ASSERT_FALSE(board.takeReply().reading) << text;
    }
  }
}

TEST_F(BoardPolling, tells_that_nothing_is_perceived_any_more) {
  tellOne();
  board.board->poll().setSource([](javinolib::Percepts &) {});
  board.hold(PERCEPTS, 100);
  EXPECT_LE(untilReply(), 20u);
  const PollReply reply = board.takeReply();
  EXPECT_TRUE(reply.reading);
  EXPECT_TRUE(reply.records.empty());
}

TEST_F(BoardPolling, reads_the_sensors_as_often_as_the_sketch_says) {
  tellOne();
  for (const uint16_t every : {20, 1, 7, 1000}) {  // 20 is the default
    if (every != 20) board.board->poll().sampleEvery(every);
    board.hold(PERCEPTS, 60000);
    board.pass(2 * every);  // the phase of the samples is that of the last one
    readings = 0;
    board.pass(10 * every);
    EXPECT_EQ(10, readings) << every;
    board.sendRaw({0});
  }
}

TEST_F(BoardPolling, reads_the_sensors_once_more_when_the_hold_is_over) {
  tellOne();
  board.board->poll().sampleEvery(1000);
  board.hold(PERCEPTS, 30);
  board.pass(29);
  shown = 3;
  board.pass(1);
  expectReading(3);
  board.hold(PERCEPTS, 0);
  expectNothing();
  shown = 4;
  board.hold(PERCEPTS, 0);
  expectReading(4);
}

TEST_F(BoardPolling, leaves_the_least_time_between_two_readings_told) {
  tellOne();
  for (shown = 1; shown < 5; shown++) {
    board.hold(PERCEPTS, 60000, 300);
    EXPECT_EQ(300u, untilReply());
    expectReading(shown);
  }
  shown = 9;
  board.hold(PERCEPTS, 100, 300);
  EXPECT_EQ(100u, untilReply()) << "the hold is over before the least time";
  expectNothing();
  board.hold(PERCEPTS, 60000, 300);
  board.receive(plain("////", "SUPO", "tell;x"));
  board.board->run();
  EXPECT_EQ(1u, board.takeReply().texts('M').size()) << "a message does not wait for the least time";
  board.pollTaking(0);
  board.hold(PERCEPTS, 60000, 0xFFFFFF);
  expectReading(9);
  shown = 10;
  board.hold(PERCEPTS, 60000, 0xFFFFFF);
  EXPECT_EQ(60000u, untilReply());
  expectNothing();
}

TEST_F(BoardPolling, a_reading_that_is_asked_for_now_is_told_whatever_was_told_before) {
  tellOne();
  for (int i = 1; i < 4; i++) {
    board.hold(PERCEPTS_NOW, 60000, 0xFFFFFF);
    expectReading(0);
    EXPECT_EQ(1 + i, readings);
  }
  board.hold(PERCEPTS, 100, 0);
  EXPECT_EQ(100u, untilReply()) << "that was the last one told";
  expectNothing();
}

TEST_F(BoardPolling, forgets_the_reading_told_at_hello_and_when_percepts_are_not_wanted) {
  tellOne();
  board.hello();
  board.hold(PERCEPTS, 60000, 0xFFFFFF);
  expectReading(0);
  board.hold(NO_PERCEPTS, 0);
  expectNothing();
  board.hold(PERCEPTS, 60000, 0xFFFFFF);
  expectReading(0);
}

TEST_F(BoardPolling, tells_a_board_without_percepts_once_that_there_are_none) {
  board.board->poll().setSource(nullptr);
  board.hold(PERCEPTS, 60000);
  const PollReply reply = board.takeReply();
  EXPECT_TRUE(reply.reading);
  EXPECT_TRUE(reply.records.empty());
  board.hold(PERCEPTS, 200);
  EXPECT_EQ(200u, untilReply());
  expectNothing();
}

TEST_F(BoardPolling, works_on_while_the_clock_goes_around) {
  board.clock.millis = UINT32_MAX - 50;
  tellOne();
  board.hold(PERCEPTS, 100);
  EXPECT_EQ(100u, untilReply());
  expectNothing();
  board.clock.millis = UINT32_MAX - 5;
  board.hold(PERCEPTS_NOW, 0);
  expectReading(0);
  shown = 1;
  board.hold(PERCEPTS, 100, 10);
  EXPECT_EQ(20u, untilReply());
  expectReading(1);
}

TEST_F(BoardPolling, tells_a_change_after_a_month_without_one) {
  tellOne();
  board.clock.millis += 30u * 24 * 3600 * 1000;
  shown = 1;
  board.hold(PERCEPTS, 1000, 500);
  EXPECT_EQ(0u, untilReply());
  expectReading(1);
}

TEST_F(BoardPolling, a_hello_ends_a_hold_and_is_answered) {
  board.hold(PERCEPTS, 60000);
  board.takeReply();
  board.hold(PERCEPTS, 60000);
  const std::vector<Bytes> replies =
      board.sendRaw(Bytes{0} + reference::packet(9, reference::frame("++++", "++++", {'H', 1})));
  ASSERT_EQ(2u, replies.size());
  EXPECT_EQ(9, reference::cobsDecoded(replies[1])[0]);
}

TEST_F(BoardPolling, other_flags_and_lengths_are_bad_arguments_and_are_not_held) {
  for (const Bytes &body :
       {Bytes{}, Bytes{0}, Bytes{0, 9, 9, 0, 0}, Bytes{0, 9, 9, 0, 0, 0, 0, 0}, Bytes{2, 9, 9, 0, 0, 0},
        Bytes{6, 9, 9, 0, 0, 0}, Bytes{16, 9, 9, 0, 0, 0}, Bytes{0x81, 9, 9, 0, 0, 0}}) {
    const std::vector<Bytes> replies =
        board.sendRaw(reference::packet(200, reference::frame("++++", "++++", Bytes{'P'} + body)));
    ASSERT_EQ(1u, replies.size()) << toHex(body);
    EXPECT_EQ(static_cast<uint8_t>(Status::BAD_ARGUMENT), reference::cobsDecoded(replies[0])[11]) << toHex(body);
  }
}

TEST_F(BoardPolling, tells_again_what_a_lost_reply_told) {
  board.transmit("////", "ROMA", "tell;x");
  board.sendNext();
  const std::vector<std::string> told = board.poll().texts('T');
  ASSERT_EQ(1u, told.size());
  board.request('R', {1});
  board.hold(REPLY_LOST, 0);
  EXPECT_EQ(told, board.takeReply().texts('T'));
  board.hold(NO_PERCEPTS, 0);
  expectNothing();
  tellOne();
  board.hold(PERCEPTS | REPLY_LOST, 1000);
  expectReading(shown);
}

TEST_F(BoardPolling, neither_forgets_nor_tells_again_what_a_reply_told_that_is_coming) {
  board.transmit("////", "ROMA", "tell;x");
  board.sendNext();
  const std::vector<std::string> told = board.poll().texts('T');
  ASSERT_EQ(1u, told.size());
  board.hold(REPLY_COMING, 0);
  expectNothing();
  board.hold(REPLY_LOST, 0);
  EXPECT_EQ(told, board.takeReply().texts('T'));
  board.hold(NO_PERCEPTS, 0);
  expectNothing();
  board.hold(REPLY_LOST, 0);
  expectNothing();
  tellOne();
  board.hold(PERCEPTS | REPLY_COMING, 5);
  EXPECT_LT(0u, untilReply());
  expectNothing();
}

TEST_F(BoardPolling, a_repeat_of_a_poll_that_is_held_ends_the_hold_and_is_answered_from_memory) {
  const Bytes poll = reference::packet(200, reference::frame("++++", "++++", {'P', 0, 0xFF, 0xFF, 0, 0, 0}));
  EXPECT_TRUE(board.sendRaw(poll).empty());
  const std::vector<Bytes> replies = board.sendRaw(Bytes{0} + poll);
  ASSERT_EQ(2u, replies.size());
  EXPECT_EQ(replies[0], replies[1]);
  EXPECT_EQ(1u, board.counter(javinolib::Counter::SERIAL_REPEATS));
}

TEST_F(BoardPolling, each_reply_says_which_timer_is_taken) {
  EXPECT_EQ(0x00, board.request(bytesOf(std::string("P\0\0\0\0\0\0", 7))).body.at(0));
  takenTimer = 0x20;
  EXPECT_EQ(0x20, board.request(bytesOf(std::string("P\0\0\0\0\0\0", 7))).body.at(0));
  EXPECT_EQ(0x24, board.request(bytesOf(std::string("P\3\0\0\0\0\0", 7))).body.at(0)) << "beside a reading";
}

TEST_F(BoardPolling, damage_ends_a_hold_and_is_not_answered) {
  board.hold(NO_PERCEPTS, 60000);
  EXPECT_EQ(1u, board.sendRaw({5, 5, 0}).size());
  EXPECT_EQ(1u, board.counter(javinolib::Counter::SERIAL_DAMAGED));
}

TEST_F(BoardPolling, a_repeated_poll_brings_the_same_again) {
  board.transmit("////", "ROMA", "tell;x");
  board.sendNext();
  const Bytes poll = reference::packet(200, reference::frame("++++", "++++", {'P', 0, 0, 0, 0, 0, 0}));
  const std::vector<Bytes> first = board.sendRaw(poll);
  EXPECT_EQ(first, board.sendRaw(poll));
}

TEST_F(BoardPolling, a_repeated_poll_also_brings_what_is_new) {
  board.transmit("////", "ROMA", "tell;x");
  board.sendNext();
  const Bytes poll = reference::packet(200, reference::frame("++++", "++++", {'P', 0, 0, 0, 0, 0, 0}));
  const std::vector<Bytes> first = board.sendRaw(poll);
  board.receive(plain("////", "SUPO", "tell;y"));
  const std::vector<Bytes> second = board.sendRaw(poll);
  ASSERT_EQ(1u, second.size());
  EXPECT_LT(first[0].size(), second[0].size());
  EXPECT_EQ(1u, board.poll().records.size()) << "all but the message, which is not taken, is deleted";
}

TEST_F(BoardPolling, a_repeated_poll_brings_an_unchanged_reading_again) {
  const Bytes poll = reference::packet(200, reference::frame("++++", "++++", {'P', 1, 0xFF, 0xFF, 0, 0, 0}));
  const std::vector<Bytes> first = board.sendRaw(poll);
  ASSERT_EQ(1u, first.size());
  EXPECT_EQ(first, board.sendRaw(poll));
}

TEST_F(BoardPolling, statistics_tell_all_counters_the_last_first) {
  board.radio.counts = {0x01020304, 6, 7, 17, 28, 41, 0, 43};
  const Bytes body = board.request('S').body;
  ASSERT_EQ(javinolib::Counters::COUNT * 5u, body.size());
  for (size_t i = 0; i < javinolib::Counters::COUNT; i++) EXPECT_EQ(javinolib::Counters::COUNT - i, body[i * 5]);
  EXPECT_EQ(0x01020304u, board.counter(javinolib::Counter::RADIO_RECEIVED));
  EXPECT_EQ(6u, board.counter(javinolib::Counter::RADIO_DAMAGED));
  EXPECT_EQ(7u, board.counter(javinolib::Counter::RADIO_MISSED));
  EXPECT_EQ(17u, board.counter(javinolib::Counter::RADIO_SENT));
  EXPECT_EQ(28u, board.counter(javinolib::Counter::RADIO_MENDED));
  EXPECT_EQ(41u, board.counter(javinolib::Counter::RADIO_LATE_MICROS));
  EXPECT_EQ(43u, board.counter(javinolib::Counter::AIRTIME_WAIT));
  board.reboot();
  board.hello();
  EXPECT_EQ(2u, board.counter(javinolib::Counter::SERIAL_REQUESTS)) << "all start at 0 at each boot";
}

TEST(Counters, stop_at_their_greatest_value) {
  uint8_t counter = 0xFE;
  for (int i = 0; i < 3; i++) javinolib::countUp(counter);
  EXPECT_EQ(0xFF, counter);
}
