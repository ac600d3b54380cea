#include <Arduino.h>
#include <board/Percepts.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/TestBoard.h"

using javinolib::Percepts;

namespace {

double celsius;

std::string toldAt(TestBoard &board, double value) {
  celsius = value;
  board.hold(PERCEPTS, 1);
  board.pass(1);
  const PollReply reply = board.takeReply();
  return reply.reading ? reply.texts('P').at(0) : "unchanged";
}

}  // namespace

TEST(Decimals, are_two_and_rounded) {
  const struct {
    double number;
    const char *text;
  } all[] = {{0, "t(0.00)"},
             {20.99, "t(20.99)"},
             {20.994, "t(20.99)"},
             {20.996, "t(21.00)"},
             {0.05, "t(0.05)"},
             {0.5, "t(0.50)"},
             {-0.5, "t(-0.50)"},
             {-0.004, "t(0.00)"},
             {-0.006, "t(-0.01)"},
             {-20.996, "t(-21.00)"},
             {655.36, "t(655.36)"},
             {-12345.67, "t(-12345.67)"},
             {100000, "t(100000.00)"},
             {20999999, "t(20999999.00)"},
             {-20999999, "t(-20999999.00)"}};
  TestBoard board;
  board.start();
  board.board->poll().setSource([](Percepts &percepts) { percepts.add(F("t"), celsius); });
  for (const auto &each : all) {
    celsius = each.number;
    EXPECT_EQ(std::vector<std::string>{each.text}, board.poll(true).texts('P')) << each.number;
  }
}

TEST(Decimals, a_float_is_a_number_like_a_double) {
  TestBoard board;
  board.start();
  board.board->poll().setSource([](Percepts &percepts) {
    percepts.add(F("t"), 20.99f);
    percepts.add(F("t"), 20.99f, 0.5f);
  });
  EXPECT_EQ((std::vector<std::string>{"t(20.99)", "t(20.99)"}), board.poll(true).texts('P'));
}

TEST(Decimals, a_number_that_cannot_be_written_is_left_out_and_told_so) {
  TestBoard board;
  board.start();
  board.board->poll().setSource([](Percepts &percepts) {
    percepts.add(F("t"), celsius);
    percepts.add(F("t"), celsius, 0.5);
    percepts.add(F("dark"));
  });
  for (double number : {std::nan(""), 21e6, -21e6, HUGE_VAL, -HUGE_VAL}) {
    celsius = number;
    const PollReply reply = board.poll(true);
    EXPECT_TRUE(reply.leftOut) << number;
    EXPECT_EQ(std::vector<std::string>{"dark"}, reply.texts('P')) << number;
  }
}

TEST(Decimals, a_value_stays_until_it_differs_by_the_dead_band) {
  TestBoard board;
  board.start();
  board.board->poll().sampleEvery(1);
  board.board->poll().setSource([](Percepts &percepts) { percepts.add(F("t"), celsius, 0.5); });
  EXPECT_EQ("t(20.00)", toldAt(board, 20));
  EXPECT_EQ("unchanged", toldAt(board, 20.49));
  EXPECT_EQ("t(20.50)", toldAt(board, 20.5));
  EXPECT_EQ("unchanged", toldAt(board, 20.01));
  EXPECT_EQ("t(-0.25)", toldAt(board, -0.25));
  EXPECT_EQ("unchanged", toldAt(board, 0.24));
  EXPECT_EQ("t(0.25)", toldAt(board, 0.25));
}

TEST(Decimals, a_value_keeps_its_least_time_beside_a_whole_dead_band) {
  TestBoard board;
  board.start();
  board.board->poll().sampleEvery(1);
  board.board->poll().setSource([](Percepts &percepts) { percepts.add(F("t"), celsius, 2, 100); });
  EXPECT_EQ("t(20.00)", toldAt(board, 20));
  board.pass(97);
  EXPECT_EQ("unchanged", toldAt(board, 25));
  EXPECT_EQ("t(25.00)", toldAt(board, 25));
}

TEST(Percepts, take_an_Arduino_String_as_a_text_and_as_a_literal) {
  TestBoard board;
  board.start();
  board.board->poll().setSource([](Percepts &percepts) {
    percepts.literal("t(" + String(20.99) + ")");
    percepts.add(F("says"), String("a \"b\""));
  });
  EXPECT_EQ((std::vector<std::string>{"t(20.99)", "says(\"a \\\"b\\\"\")"}), board.poll(true).texts('P'));
}
