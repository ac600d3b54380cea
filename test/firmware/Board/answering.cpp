#include <Arduino.h>
#include <gtest/gtest.h>

#include "support/CommandLetters.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

// A board without a radio that was greeted.
class BoardWithoutRadio : public testing::Test {
 protected:
  BoardWithoutRadio() { board.hello(); }

  PlainBoard board;
};

}  // namespace

TEST_F(BoardWithoutRadio, tells_that_it_has_no_radio_no_memory_and_no_epoch) {
  EXPECT_EQ(bytesOf("\x01++++") + fromHex("00000000") + bytesOf("plain 1.0"), board.hello().body);
}

TEST_F(BoardWithoutRadio, answers_NO_RADIO_to_all_that_only_a_radio_does) {
  for (char command : radioCommandLetters()) {
    EXPECT_EQ(Status::NO_RADIO, board.request(command).status) << command;
    EXPECT_EQ(Status::NO_RADIO, board.request(command, bytesOf("ROMA")).status) << command;
  }
  for (const char *destination : {"////", "ROMA", "//SU", "+FAA"}) {
    EXPECT_EQ(Status::NO_RADIO, board.transmit(destination, "SUPO", "tell;x").status) << destination;
  }
}

TEST_F(BoardWithoutRadio, answers_UNKNOWN_COMMAND_to_every_other_command_byte) {
  for (int command = 0; command < 256; command++) {
    if (commandLetters().find(static_cast<char>(command)) != std::string::npos) continue;
    EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request(Bytes(1, static_cast<uint8_t>(command))).status) << command;
  }
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request(Bytes()).status);
  EXPECT_EQ(Status::WRONG_ORIGIN, board.exchange(reference::frame("++++", "ROMA", {'S'})).status);
}

TEST_F(BoardWithoutRadio, performs_nothing_but_hello_after_each_boot) {
  for (int boot = 0; boot < 2; boot++) {
    board.reboot();
    EXPECT_EQ((Bytes{0, 1, 0}), board.port.takeWritten()) << "it has the host ask again";
    for (char command : commandLetters() + "Z") {
      if (command == 'H') continue;
      EXPECT_EQ(Status::NOT_GREETED, board.request(command).status) << command;
    }
    EXPECT_EQ(Status::NOT_GREETED, board.transmit("////", "ROMA", "tell;x").status);
    EXPECT_EQ(Status::OK, board.hello().status);
    EXPECT_EQ(Status::OK, board.request('S').status);
  }
}

TEST_F(BoardWithoutRadio, performs_and_lists_actions) {
  board.board->actions().add(F("go"), [](const javinolib::Arguments &) { return true; });
  board.board->actions().add(F("stay"), [](const javinolib::Arguments &) { return false; });
  EXPECT_EQ(Status::OK, board.request(bytesOf("Ago(3)")).status);
  EXPECT_EQ(Status::ACTION_FAILED, board.request(bytesOf("Astay")).status);
  EXPECT_EQ(Status::UNKNOWN_ACTION, board.request(bytesOf("Afly")).status);
  EXPECT_EQ(Status::BAD_ARGUMENT, board.request(bytesOf("Ago(")).status);
  EXPECT_EQ(Bytes{2} + bytesOf(std::string("go\0stay\0", 8)), board.request('C', {0, 0}).body);
}

TEST_F(BoardWithoutRadio, performs_a_repeat_once) {
  static int performed;
  performed = 0;
  board.board->actions().add(F("count"), [](const javinolib::Arguments &) { return ++performed != 0; });
  const Bytes request = reference::packet(100, reference::frame("++++", "++++", bytesOf("Acount")));
  const std::vector<Bytes> first = board.sendRaw(request);
  EXPECT_EQ(first, board.sendRaw(request));
  EXPECT_EQ(1, performed);
  EXPECT_EQ(1u, board.counter(Counter::SERIAL_REPEATS));
}

TEST_F(BoardWithoutRadio, holds_a_poll_until_a_reading_changes_or_its_time_is_over) {
  static int level;
  level = 1;
  board.board->poll().setSource([](javinolib::Percepts &percepts) { percepts.add(F("level"), level); });
  board.hold(PERCEPTS, 1000);
  EXPECT_EQ(std::vector<std::string>{"level(1)"}, board.takeReply().texts('P'));
  board.hold(PERCEPTS, 1000);
  board.pass(999);
  EXPECT_FALSE(board.replies());
  EXPECT_TRUE(board.board->isIdle());
  board.pass(1);
  EXPECT_FALSE(board.takeReply().reading);
  board.hold(PERCEPTS, 1000);
  level = 2;
  board.pass(20);
  EXPECT_EQ(std::vector<std::string>{"level(2)"}, board.takeReply().texts('P'));
  EXPECT_EQ(Status::BAD_ARGUMENT, board.request('P', {2, 0, 0, 0, 0, 0}).status);
}

TEST_F(BoardWithoutRadio, counts_what_the_line_brings_and_tells_only_that) {
  board.sendRaw({2, 1, 0});
  board.sendRaw(reference::packet(1, bytesOf("++++++-+AA")));
  const Bytes body = board.request('S').body;
  const uint8_t numbers[] = {1, 2, 3, 4, 18, 38, 39, 40};
  ASSERT_EQ(5 * sizeof numbers, body.size());
  for (size_t i = 0; i < sizeof numbers; i++) EXPECT_EQ(numbers[i], body[5 * i]);
  EXPECT_EQ(1u, board.counter(Counter::SERIAL_DAMAGED));
  EXPECT_EQ(1u, board.counter(Counter::SERIAL_BAD_FRAMES));
  EXPECT_EQ(5u, board.counter(Counter::SERIAL_REQUESTS));
}

TEST_F(BoardWithoutRadio, takes_the_longest_request_and_refuses_a_longer_one) {
  const size_t longest = javinolib::config::BOARD_MESSAGE;
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request(Bytes(longest, '?')).status);
  EXPECT_TRUE(board.sendRaw(reference::packet(9, Bytes(javinolib::HEADER_LENGTH + longest + 1, '+'))).empty());
  EXPECT_EQ(1u, board.counter(Counter::SERIAL_DAMAGED));
}

TEST_F(BoardWithoutRadio, tells_as_many_percepts_as_its_longest_reply_holds) {
  board.board->poll().setSource([](javinolib::Percepts &percepts) {
    for (int i = 0; i < 200; i++) percepts.add(F("n"), 1000 + i);
  });
  const size_t fit = (javinolib::config::BOARD_MESSAGE - 2) / (3 + 7);  // status and flags; head and text
  const PollReply reply = board.poll(true);
  EXPECT_TRUE(reply.leftOut);
  EXPECT_EQ(fit, reply.records.size());
  EXPECT_EQ(200 - fit, board.counter(Counter::PERCEPTS_LEFT_OUT));
}

TEST_F(BoardWithoutRadio, random_packets_get_one_reply_each_and_random_bytes_none) {
  RandomBytes random(18);
  for (int i = 0; i < 2000; i++) {
    const Bytes message = random.bytes(random.number(javinolib::config::BOARD_MESSAGE + 1));
    const std::string destination = random.number(4) == 0 ? "ROMA" : "++++";
    const Bytes request = reference::packet(random.byte(), reference::frame(destination, "++++", message));
    ASSERT_EQ(1u, board.sendRaw(request + Bytes{0}).size()) << toHex(message);
    ASSERT_TRUE(board.sendRaw(random.bytes(random.number(700)) + Bytes{0}).empty());
  }
}
