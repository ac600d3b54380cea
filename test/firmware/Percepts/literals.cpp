#include <Arduino.h>
#include <board/Percepts.h>
#include <gtest/gtest.h>

#include <climits>

#include "support/TestBoard.h"

using javinolib::Percepts;

namespace {

std::vector<std::string> perceived(javinolib::PerceptSource source) {
  TestBoard board;
  board.start();
  board.board->poll().setSource(source);
  return board.poll(true).texts('P');
}

typedef std::vector<std::string> Texts;

}  // namespace

TEST(Percepts, writes_names_and_numbers) {
  EXPECT_EQ((Texts{"dark", "light(0)", "light(1023)", "height(-40)", "distance(4000000000)", "pin(7)"}),
            perceived([](Percepts &percepts) {
              percepts.add(F("dark"));
              percepts.add(F("light"), 0);
              percepts.add(F("light"), 1023);
              percepts.add(F("height"), -40);
              percepts.add(F("distance"), 4000000000UL);
              percepts.add(F("pin"), static_cast<uint8_t>(7));
            }));
}

TEST(Percepts, writes_the_smallest_and_the_greatest_long) {
  EXPECT_EQ((Texts{"n(" + std::to_string(LONG_MIN) + ")", "n(" + std::to_string(LONG_MAX) + ")"}),
            perceived([](Percepts &percepts) {
              percepts.add(F("n"), LONG_MIN);
              percepts.add(F("n"), LONG_MAX);
            }));
}

TEST(Percepts, quotes_and_escapes_texts) {
  EXPECT_EQ((Texts{"says(\"hello\")", "says(\"\")", "says(\"a \\\"b\\\" \\\\ c\\nd\")", "says(\"é\")"}),
            perceived([](Percepts &percepts) {
              percepts.add(F("says"), F("hello"));
              percepts.add(F("says"), "");
              percepts.add(F("says"), "a \"b\" \\ c\nd");
              percepts.add(F("says"), "é");
            }));
}

TEST(Percepts, writes_literals_as_they_stand) {
  EXPECT_EQ((Texts{"position(3,\"km\")", "~moving"}), perceived([](Percepts &percepts) {
              percepts.literal(F("position(3,\"km\")"));
              percepts.literal("~moving");
            }));
}

TEST(Percepts, are_none_without_a_source) {
  TestBoard board;
  board.start();
  EXPECT_TRUE(board.poll(true).records.empty());
}

TEST(Percepts, are_not_asked_for_where_the_host_does_not_want_them) {
  TestBoard board;
  board.start();
  board.board->poll().setSource([](Percepts &percepts) { percepts.add(F("dark")); });
  const PollReply reply = board.poll(false);
  EXPECT_TRUE(reply.records.empty());
  EXPECT_FALSE(reply.reading);
}

TEST(Percepts, what_does_not_fit_is_left_out_whole_told_and_counted) {
  TestBoard board;
  board.start();
  board.board->poll().setSource([](Percepts &percepts) {
    for (int i = 0; i < 100; i++) percepts.add(F("something"), 100 + i);  // 14 + 3 bytes each, 509 in all
    percepts.add(F("x"));
  });
  const PollReply reply = board.poll(true);
  EXPECT_TRUE(reply.leftOut);
  EXPECT_EQ(30u, reply.records.size()) << "29 long ones, and the short one that still fits behind them";
  EXPECT_EQ("x", reply.texts('P').back());
  EXPECT_EQ(71u, board.counter(javinolib::Counter::PERCEPTS_LEFT_OUT));
  board.hold(1, 100);
  board.pass(100);
  EXPECT_FALSE(board.takeReply().reading);
  EXPECT_EQ(71u, board.counter(javinolib::Counter::PERCEPTS_LEFT_OUT)) << "only readings that are told count";
}

TEST(Percepts, writes_numbers_of_each_length) {
  static unsigned long number;
  TestBoard board;
  board.start();
  board.board->poll().setSource([](Percepts &percepts) {
    percepts.add(F("n"), number);
    percepts.add(F("n"), -static_cast<long>(number));
  });
  for (const uint64_t middle : {0ULL, 10ULL, 100ULL, 1000ULL, 10000ULL, 65536ULL, 100000ULL, 655360ULL, 1000000ULL,
                                10000000ULL, 100000000ULL, 1000000000ULL, 2147483640ULL}) {
    for (uint64_t value = middle < 3 ? 0 : middle - 3; value < middle + 3; value++) {
      number = static_cast<unsigned long>(value);
      const std::string text = std::to_string(value);
      const std::string negative = value == 0 ? "n(0)" : "n(-" + text + ")";
      ASSERT_EQ((Texts{"n(" + text + ")", negative}), board.poll(true).texts('P'));
    }
  }
}
