#include <Arduino.h>
#include <gtest/gtest.h>

#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

// The number that is its argument.
bool same(const javinolib::Arguments &arguments, javinolib::Result &result) {
  long number;
  if (!arguments.integer(0, number)) return false;
  const bool fits = result.number(number);
  EXPECT_EQ(number >= -8388608 && number <= 8388607, fits) << number;
  return true;
}

bool none(const javinolib::Arguments &, javinolib::Result &) { return true; }
bool plain(const javinolib::Arguments &) { return true; }
bool refuse(const javinolib::Arguments &, javinolib::Result &result) {
  result.number(5);
  return false;
}

class Results : public testing::Test {
 protected:
  Results() {
    board.hello();
    board.board->actions().add(F("before"), plain);
    EXPECT_TRUE(board.board->actions().addResult(F("same"), same));
    board.board->actions().add(F("behind"), plain);
    EXPECT_TRUE(board.board->actions().addResult(F("none"), none));
    EXPECT_TRUE(board.board->actions().addResult(F("refuse"), refuse));
    EXPECT_FALSE(board.board->actions().addResult(F("before"), same)) << "the name is taken";
  }

  BoardReply act(const std::string &action) { return board.request('A', bytesOf(action)); }

  PlainBoard board;
};

}  // namespace

TEST_F(Results, are_numbers_of_24_bits_in_the_place_of_the_request) {
  for (long number : {0L, 1L, -1L, 470L, 8388607L, -8388608L}) {
    const BoardReply reply = act("same(" + std::to_string(number) + ")");
    EXPECT_EQ(Status::OK, reply.status);
    const Bytes bytes = {static_cast<uint8_t>(number >> 16), static_cast<uint8_t>(number >> 8),
                         static_cast<uint8_t>(number)};
    EXPECT_EQ(bytes, reply.body) << number;
  }
}

TEST_F(Results, beyond_24_bits_are_left_out_and_counted) {
  for (long number : {8388608L, -8388609L, 2147483647L}) {
    const BoardReply reply = act("same(" + std::to_string(number) + ")");
    EXPECT_EQ(Status::OK, reply.status) << "it was performed";
    EXPECT_EQ(Bytes(), reply.body);
  }
  EXPECT_EQ(3u, board.counter(Counter::PERCEPTS_LEFT_OUT));
}

TEST_F(Results, come_from_actions_that_have_one_only) {
  for (const char *action : {"before", "behind", "none"}) {
    EXPECT_EQ(Status::OK, act(action).status) << action;
    EXPECT_EQ(Bytes(), act(action).body) << action;
  }
  EXPECT_EQ(Status::ACTION_FAILED, act("refuse").status);
  EXPECT_EQ(Bytes(), act("refuse").body);
  EXPECT_EQ(Status::ACTION_FAILED, act("same").status);
  EXPECT_EQ(Status::BAD_ARGUMENT, act("same(").status);
  EXPECT_EQ(Status::UNKNOWN_ACTION, act("other").status);
  EXPECT_EQ(0u, board.counter(Counter::PERCEPTS_LEFT_OUT));
}
