#include <Arduino.h>
#include <gtest/gtest.h>

#include "support/TestBoard.h"

using javinolib::Percepts;

namespace {

typedef std::vector<std::string> Texts;

bool isPressed;
int reading;
unsigned long tag;

const Texts PRESSED = {"pressed"};
const Texts UNCHANGED = {"unchanged"};

// A board that reads its sensors each millisecond, and a host that has had their first reading.
class Events : public testing::Test {
 protected:
  Events() {
    isPressed = false;
    reading = 0;
    board.start();
    board.board->poll().sampleEvery(1);
    board.board->poll().setSource([](Percepts &percepts) { percepts.event(F("pressed"), isPressed); });
    board.hold(PERCEPTS, 0);
    board.takeReply();
  }

  // Lasts for one reading.
  void press() {
    isPressed = true;
    board.pass(1);
    isPressed = false;
  }

  Texts told() {
    const PollReply reply = board.takeReply();
    return reply.reading ? reply.texts('P') : UNCHANGED;
  }

  // The reply to a poll that is held for a while.
  Texts polled(uint8_t flags = PERCEPTS) {
    board.hold(flags, 5);
    board.pass(5);
    return told();
  }

  TestBoard board;
};

}  // namespace

TEST_F(Events, that_lasts_for_one_reading_is_told_once) {
  board.hold(PERCEPTS, 1000);
  press();
  EXPECT_EQ(PRESSED, told());
  EXPECT_EQ(Texts{}, polled()) << "the host has had it";
  EXPECT_EQ(UNCHANGED, polled());
}

// Events with numbers.
class Tags : public Events {
 protected:
  Tags() {
    board.board->poll().setSource([](Percepts &percepts) { percepts.event(F("tag"), isPressed, tag); });
  }

  // Is read in one reading.
  void read(unsigned long number) {
    tag = number;
    press();
    tag = 0;
  }

  uint32_t replaced() { return board.counter(javinolib::Counter::PERCEPTS_LEFT_OUT); }
};

TEST_F(Tags, are_told_once_with_their_numbers) {
  for (unsigned long number : {4711ul, 0ul, 4294967295ul, 4711ul}) {
    board.hold(PERCEPTS, 1000);
    read(number);
    EXPECT_EQ((Texts{"tag(" + std::to_string(number) + ")"}), told());
    EXPECT_EQ(Texts{}, polled()) << "the host has had it";
    EXPECT_EQ(UNCHANGED, polled());
  }
  EXPECT_EQ(0u, replaced());
}

TEST_F(Tags, give_way_to_the_next_before_they_are_told_and_are_counted) {
  board.hold(PERCEPTS, 1000, 500);
  board.pass(100);
  read(1);
  board.pass(1);
  read(1);
  board.pass(1);
  read(2);
  board.pass(396);
  EXPECT_EQ((Texts{"tag(2)"}), told());
  EXPECT_EQ(Texts{}, polled());
  EXPECT_EQ(1u, replaced()) << "the same number is the same event";
}

TEST_F(Tags, that_follow_each_other_without_a_gap_are_all_told) {
  isPressed = true;
  for (tag = 1; tag < 4; tag++) {
    board.hold(PERCEPTS, 1000);
    board.pass(1);
    EXPECT_EQ((Texts{"tag(" + std::to_string(tag) + ")"}), told());
  }
  isPressed = false;
  EXPECT_EQ((Texts{"tag(3)"}), polled(PERCEPTS | REPLY_LOST));
  EXPECT_EQ(Texts{}, polled());
  EXPECT_EQ(0u, replaced());
}

TEST_F(Tags, that_come_again_before_the_host_knows_that_they_are_over_are_told_once_more) {
  for (unsigned long second : {7ul, 8ul}) {
    board.hold(PERCEPTS, 1000);
    read(7);
    EXPECT_EQ((Texts{"tag(7)"}), told());
    board.hold(PERCEPTS, 1000, 5);
    board.pass(1);
    read(second);
    board.pass(3);
    EXPECT_EQ(Texts{}, told()) << "that the first one is over";
    EXPECT_EQ((Texts{"tag(" + std::to_string(second) + ")"}), polled());
    EXPECT_EQ(Texts{}, polled());
  }
  EXPECT_EQ(0u, replaced());
}

TEST_F(Tags, whose_reply_is_lost_are_told_again_or_counted) {
  board.hold(PERCEPTS, 1000);
  read(7);
  EXPECT_EQ((Texts{"tag(7)"}), told());
  board.hold(PERCEPTS | REPLY_LOST, 1000);
  EXPECT_EQ((Texts{"tag(7)"}), told());
  board.hold(PERCEPTS | REPLY_COMING, 1000);
  read(8);
  EXPECT_EQ((Texts{"tag(8)"}), told()) << "7 may be lost";
  EXPECT_EQ((Texts{"tag(8)"}), polled(PERCEPTS | REPLY_LOST));
  EXPECT_EQ(Texts{}, polled());
  EXPECT_EQ(1u, replaced());
}

TEST_F(Events, that_lasts_is_told_until_it_is_over) {
  board.hold(PERCEPTS, 1000);
  isPressed = true;
  board.pass(1);
  EXPECT_EQ(PRESSED, told());
  for (int i = 0; i < 3; i++) EXPECT_EQ(UNCHANGED, polled());
  isPressed = false;
  EXPECT_EQ(Texts{}, polled());
}

TEST_F(Events, that_happens_again_before_the_host_knows_that_it_is_over_is_told_once_more) {
  board.hold(PERCEPTS, 1000);
  press();
  EXPECT_EQ(PRESSED, told());
  board.hold(PERCEPTS, 1000, 500);
  board.pass(100);
  press();
  board.pass(398);
  EXPECT_FALSE(board.replies());
  board.pass(1);
  EXPECT_EQ(Texts{}, told()) << "that the first one is over";
  board.hold(PERCEPTS, 1000, 500);
  board.pass(499);
  EXPECT_FALSE(board.replies());
  board.pass(1);
  EXPECT_EQ(PRESSED, told());
}

TEST_F(Events, is_told_when_the_least_time_is_over) {
  board.hold(PERCEPTS, 1000, 500);
  board.pass(100);
  press();
  board.pass(398);
  EXPECT_FALSE(board.replies());
  board.pass(1);
  EXPECT_EQ(PRESSED, told());
}

TEST_F(Events, whose_reply_is_lost_is_told_again) {
  board.hold(PERCEPTS, 1000);
  press();
  EXPECT_EQ(PRESSED, told());
  for (int i = 0; i < 3; i++) EXPECT_EQ(PRESSED, polled(PERCEPTS | REPLY_LOST));
  board.hello();
  EXPECT_EQ(PRESSED, polled()) << "nor does a host that starts anew know it";
  EXPECT_EQ(Texts{}, polled());
}

TEST_F(Events, whose_reply_is_lost_after_the_next_poll_is_told_once_more) {
  board.board->poll().setSource([](Percepts &percepts) {
    percepts.event(F("pressed"), isPressed);
    percepts.add(F("level"), reading++);
  });
  board.hold(PERCEPTS, 1000);
  press();
  EXPECT_EQ((Texts{"pressed", "level(0)"}), told());
  EXPECT_EQ((Texts{"level(1)"}), polled(PERCEPTS | REPLY_COMING));
  EXPECT_EQ((Texts{"pressed", "level(2)"}), polled(PERCEPTS | REPLY_COMING | REPLY_LOST));
  EXPECT_EQ((Texts{"level(3)"}), polled(PERCEPTS | REPLY_COMING));
  EXPECT_EQ((Texts{"level(4)"}), polled(PERCEPTS | REPLY_COMING));
}

TEST_F(Events, is_over_for_a_host_whose_reply_is_still_to_come) {
  for (int i = 0; i < 3; i++) {
    board.hold(i == 0 ? PERCEPTS : PERCEPTS | REPLY_COMING, 1000);
    press();
    EXPECT_EQ(PRESSED, told());
    board.hold(PERCEPTS | REPLY_COMING, 1000);
    board.pass(1);
    EXPECT_EQ(Texts{}, told());
  }
}

TEST_F(Events, is_told_once_more_to_a_host_that_asks_for_a_reading_now_if_it_has_not_had_it) {
  press();
  EXPECT_EQ(Texts{}, board.poll(true).texts('P')) << "no poll was held: nobody looked";
  board.hold(PERCEPTS, 1000, 500);
  press();
  board.sendRaw({0});
  EXPECT_EQ(PRESSED, board.poll(true).texts('P'));
  EXPECT_EQ(Texts{}, board.poll(true).texts('P'));
}
