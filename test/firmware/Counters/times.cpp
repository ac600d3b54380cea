#include <Arduino.h>
#include <gtest/gtest.h>

#include "support/TestBoard.h"

using javinolib::Counter;

namespace {

FakeClock *current;
uint32_t lasts;

// A board whose functions take a while.
template <typename Board>
class Times : public testing::Test {
 protected:
  Times() {
    current = &board.clock;
    lasts = 0;
    board.hello();
    board.board->poll().setSource([](javinolib::Percepts &) { current->millis += lasts; });
    board.board->actions().add(F("work"), [](const javinolib::Arguments &) {
      current->millis += lasts;
      return true;
    });
  }

  void perceive(uint32_t millis) {
    lasts = millis;
    board.poll(true);
  }

  void act(uint32_t millis) {
    lasts = millis;
    board.request(bytesOf("Awork"));
  }

  void pause(uint32_t millis) {
    board.clock.millis += millis;
    board.sendRaw({0});
  }

  void expect(uint32_t loop, uint32_t percepts, uint32_t action) {
    EXPECT_EQ(loop, board.counter(Counter::LOOP_MILLIS));
    EXPECT_EQ(percepts, board.counter(Counter::PERCEPTS_MILLIS));
    EXPECT_EQ(action, board.counter(Counter::ACTION_MILLIS));
  }

  Board board;
};

typedef testing::Types<PlainBoard, TestBoard> Boards;
TYPED_TEST_SUITE(Times, Boards, );

}  // namespace

TYPED_TEST(Times, are_the_longest_since_the_boot_each_for_itself) {
  this->expect(0, 0, 0);
  this->perceive(250);
  this->expect(0, 250, 0);
  this->act(1000);
  this->pause(30);
  this->expect(30, 250, 1000);
  this->perceive(249);
  this->act(999);
  this->pause(29);
  this->expect(30, 250, 1000);
  this->perceive(251);
  this->act(1001);
  this->pause(31);
  this->expect(31, 251, 1001);
  this->board.reboot();
  this->board.hello();
  this->expect(0, 0, 0);
}

TYPED_TEST(Times, are_65535_ms_at_most) {
  this->pause(65535);
  this->expect(65535, 0, 0);
}

TYPED_TEST(Times, begin_with_begin_and_outlive_the_clock_s_overflow) {
  this->board.clock.millis = UINT32_MAX - 5;
  this->board.board->begin();
  this->pause(20);
  this->expect(20, 0, 0);
}

TEST(RadioBoardTimes, leave_out_what_the_board_itself_takes) {
  TestBoard board;
  board.hello();
  board.radio.working = [&] { board.clock.millis += 90; };
  board.sendRaw({0});
  board.radio.working = nullptr;
  board.clock.millis += 7;
  board.sendRaw({0});
  EXPECT_EQ(7u, board.counter(Counter::LOOP_MILLIS));
}
