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

TEST(Decimals, of_what_is_no_such_number_it_is_told_why) {
  TestBoard board;
  board.start();
  board.board->poll().setSource([](Percepts &percepts) {
    percepts.add(F("t"), celsius);
    percepts.add(F("t"), celsius, 0.5);
    percepts.add(F("dark"));
  });
  const struct {
    double number;
    const char *text;
  } all[] = {{std::nan(""), "t(NaN)"}, {-std::nan(""), "t(NaN)"}, {21e6, "t(Ovf)"},     {-21e6, "t(Ovf)"},
             {123456789.0, "t(Ovf)"},  {HUGE_VAL, "t(Inf)"},      {-HUGE_VAL, "t(Inf)"}};
  for (const auto &each : all) {
    celsius = each.number;
    const PollReply reply = board.poll(true);
    EXPECT_FALSE(reply.leftOut) << each.number;
    EXPECT_EQ((std::vector<std::string>{each.text, each.text, "dark"}), reply.texts('P')) << each.number;
  }
  EXPECT_EQ(0u, board.counter(javinolib::Counter::PERCEPTS_LEFT_OUT)) << "they do fit";
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

TEST(Decimals, a_dead_band_begins_anew_after_what_is_no_number) {
  TestBoard board;
  board.start();
  board.board->poll().sampleEvery(1);
  board.board->poll().setSource([](Percepts &percepts) { percepts.add(F("t"), celsius, 0.5); });
  EXPECT_EQ("t(20.00)", toldAt(board, 20));
  EXPECT_EQ("t(NaN)", toldAt(board, std::nan("")));
  EXPECT_EQ("t(20.40)", toldAt(board, 20.4));
  EXPECT_EQ("unchanged", toldAt(board, 20.8));
  EXPECT_EQ("t(20.90)", toldAt(board, 20.9));
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
