#include <Arduino.h>
#include <gtest/gtest.h>

#include <climits>

#include "support/TestBoard.h"

using javinolib::Percepts;

namespace {

typedef std::vector<std::string> Texts;

long level;
long other;
bool levelShown;
int many;

void tremblingLevel(Percepts &percepts) {
  if (levelShown) percepts.add(F("level"), level, 10);
}

// A board that reads its sensors each millisecond, and a host that has had their first reading.
class DeadBands : public testing::Test {
 protected:
  DeadBands() {
    level = 100;
    other = 100;
    levelShown = true;
    board.start();
    board.board->poll().sampleEvery(1);
  }

  void perceive(javinolib::PerceptSource source) {
    board.board->poll().setSource(source);
    board.hold(PERCEPTS, 0);
    board.takeReply();
  }

  // The percepts told after some milliseconds; nothing if nothing has changed.
  Texts told(uint16_t afterMillis = 1) {
    board.hold(PERCEPTS, afterMillis);
    board.pass(afterMillis);
    const PollReply reply = board.takeReply();
    if (!reply.reading) return {};
    return reply.records.empty() ? Texts{"nothing perceived"} : reply.texts('P');
  }

  Texts toldAt(long newLevel, uint16_t afterMillis = 1) {
    level = newLevel;
    return told(afterMillis);
  }

  TestBoard board;
};

}  // namespace

TEST_F(DeadBands, a_value_stays_until_it_differs_by_the_dead_band) {
  perceive(tremblingLevel);
  for (const long within : {101L, 109L, 91L, 100L, 109L}) EXPECT_EQ(Texts{}, toldAt(within)) << within;
  EXPECT_EQ(Texts{"level(110)"}, toldAt(110));
  EXPECT_EQ(Texts{}, toldAt(101)) << "counted from the value told";
  EXPECT_EQ(Texts{"level(100)"}, toldAt(100));
  EXPECT_EQ(Texts{"level(90)"}, toldAt(90));
}

TEST_F(DeadBands, a_value_that_drifts_is_told_at_each_step_of_the_dead_band) {
  perceive(tremblingLevel);
  Texts all;
  for (long drift = 100; drift >= -25; drift--) {
    for (const std::string &text : toldAt(drift)) all.push_back(text);
  }
  EXPECT_EQ((Texts{"level(90)", "level(80)", "level(70)", "level(60)", "level(50)", "level(40)", "level(30)",
                   "level(20)", "level(10)", "level(0)", "level(-10)", "level(-20)"}),
            all);
}

TEST_F(DeadBands, the_greatest_and_the_least_long_are_far_apart) {
  perceive([](Percepts &percepts) { percepts.add(F("level"), level, ULONG_MAX); });
  EXPECT_EQ(Texts{}, toldAt(LONG_MIN));
  board.hello();
  perceive([](Percepts &percepts) { percepts.add(F("level"), level, ULONG_MAX); });
  EXPECT_EQ(Texts{"level(" + std::to_string(LONG_MAX) + ")"}, toldAt(LONG_MAX));
  EXPECT_EQ(Texts{"level(" + std::to_string(LONG_MIN) + ")"}, toldAt(LONG_MIN));
}

TEST_F(DeadBands, a_dead_band_of_0_is_one_of_1) {
  perceive([](Percepts &percepts) { percepts.add(F("level"), level, 0, 50); });
  EXPECT_EQ(Texts{}, told(200));
  EXPECT_EQ(Texts{"level(101)"}, toldAt(101)) << "an equal value is no change";
}

TEST_F(DeadBands, a_value_is_told_for_its_least_time) {
  perceive([](Percepts &percepts) { percepts.add(F("level"), level, 1, 500); });
  EXPECT_EQ(Texts{}, toldAt(200, 499));
  EXPECT_EQ(Texts{"level(200)"}, told(1));
  EXPECT_EQ(Texts{}, toldAt(300, 250));
  EXPECT_EQ(Texts{}, toldAt(400, 249));
  EXPECT_EQ(Texts{"level(400)"}, told(1)) << "the value of now";
  EXPECT_EQ(Texts{}, told(5000));
  EXPECT_EQ(Texts{"level(500)"}, toldAt(500)) << "nothing has changed for longer";
}

TEST_F(DeadBands, a_value_keeps_both_its_dead_band_and_its_least_time) {
  perceive([](Percepts &percepts) { percepts.add(F("level"), level, 10, 500); });
  EXPECT_EQ(Texts{}, toldAt(109, 1000));
  EXPECT_EQ(Texts{"level(110)"}, toldAt(110));
  EXPECT_EQ(Texts{}, toldAt(150, 499));
  EXPECT_EQ(Texts{}, toldAt(119, 1000)) << "it came back in time";
}

TEST_F(DeadBands, each_percept_has_its_own) {
  perceive([](Percepts &percepts) {
    percepts.add(F("level"), level, 10);
    percepts.add(F("other"), other, 3);
  });
  other = 103;
  EXPECT_EQ((Texts{"level(100)", "other(103)"}), toldAt(109));
  EXPECT_EQ((Texts{"level(110)", "other(103)"}), toldAt(110));
}

TEST_F(DeadBands, percepts_of_one_name_are_told_apart_by_their_order) {
  perceive([](Percepts &percepts) {
    const long values[] = {level, other};
    for (const long value : values) percepts.add(F("distance"), value, 10);
  });
  other = 200;
  EXPECT_EQ((Texts{"distance(100)", "distance(200)"}), toldAt(109));
  EXPECT_EQ(Texts{}, toldAt(91));
  EXPECT_EQ((Texts{"distance(90)", "distance(200)"}), toldAt(90));
}

TEST_F(DeadBands, another_percept_that_changes_does_not_bring_what_stays_within_its_dead_band) {
  perceive([](Percepts &percepts) {
    percepts.add(F("level"), level, 10);
    percepts.add(F("other"), other);
  });
  other = 101;
  EXPECT_EQ((Texts{"level(100)", "other(101)"}), toldAt(109));
}

TEST_F(DeadBands, a_percept_that_was_absent_is_told_as_it_is) {
  perceive([](Percepts &percepts) {
    if (levelShown) percepts.add(F("level"), level, 10, 60000);
  });
  levelShown = false;
  EXPECT_EQ(Texts{"nothing perceived"}, told());
  levelShown = true;
  EXPECT_EQ(Texts{"level(105)"}, toldAt(105));
  EXPECT_EQ(Texts{}, toldAt(200, 59999)) << "and its least time begins";
  EXPECT_EQ(Texts{"level(200)"}, told());
}

TEST_F(DeadBands, a_host_that_says_hello_gets_the_values_as_they_are) {
  perceive(tremblingLevel);
  EXPECT_EQ(Texts{}, toldAt(105));
  board.hello();
  EXPECT_EQ(Texts{"level(105)"}, told());
  EXPECT_EQ(Texts{}, toldAt(114));
}

TEST_F(DeadBands, a_host_that_wants_percepts_again_gets_the_values_as_they_are) {
  perceive(tremblingLevel);
  EXPECT_EQ(Texts{}, toldAt(105));
  EXPECT_FALSE(board.poll(false).reading);
  EXPECT_EQ(Texts{"level(105)"}, told());
}

TEST_F(DeadBands, a_host_that_asks_for_a_reading_now_gets_the_values_as_they_are) {
  perceive(tremblingLevel);
  EXPECT_EQ(Texts{}, toldAt(105));
  EXPECT_EQ(Texts{"level(105)"}, board.poll(true).texts('P'));
  EXPECT_EQ(Texts{}, toldAt(114)) << "counted from the value told";
  EXPECT_EQ(Texts{"level(115)"}, toldAt(115));
}

TEST_F(DeadBands, a_percept_too_many_is_told_as_it_is_and_gets_the_place_of_one_that_goes) {
  many = javinolib::config::DEAD_BANDS;
  perceive([](Percepts &percepts) {
    for (int i = 0; i < many; i++) percepts.add(F("other"), other, 10);
    percepts.add(F("level"), level, 10);
  });
  EXPECT_EQ("level(101)", toldAt(101).back());
  many--;
  EXPECT_EQ("level(102)", toldAt(102).back());
  EXPECT_EQ("level(103)", toldAt(103).back()) << "the place is free from the second reading on";
  EXPECT_EQ(Texts{}, toldAt(112));
  EXPECT_EQ("level(113)", toldAt(113).back());
}

TEST_F(DeadBands, works_on_while_the_clock_goes_around) {
  board.clock.millis = UINT32_MAX - 100;
  perceive([](Percepts &percepts) { percepts.add(F("level"), level, 1, 500); });
  EXPECT_EQ(Texts{}, toldAt(200, 499));
  EXPECT_EQ(Texts{"level(200)"}, told());
}
