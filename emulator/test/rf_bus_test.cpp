// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

extern "C" {
#include "rf_bus.h"
}

namespace {

struct Level {
  bool level;
  cycles_t at;
  bool operator==(const Level &other) const { return level == other.level && at == other.at; }
};

// A bus of boards on a line, one every 10 m.
struct Air {
  Air(size_t count, double range_m, double errors = 0, uint64_t seed = 1, std::vector<fault_config> jams = {})
      : boards(count), faults(jams), levels(count) {
    for (size_t i = 0; i < count; i++) boards[i].x_m = 10.0 * static_cast<double>(i);
    scenario config = {{2000, range_m, errors}, boards.data(), count, faults.data(), faults.size(), {}};
    EXPECT_EQ(rf_bus_init(&bus, &config, seed, {this, on_level, on_collision}), 0);
  }
  ~Air() { rf_bus_release(&bus); }

  static void on_level(void *context, size_t receiver, bool level, cycles_t at) {
    static_cast<Air *>(context)->levels[receiver].push_back({level, at});
  }

  static void on_collision(void *context, size_t receiver, uint64_t sources, cycles_t) {
    static_cast<Air *>(context)->collisions.emplace_back(receiver, sources);
  }

  void pulse(size_t source, cycles_t from, cycles_t to) {
    rf_bus_carrier(&bus, source, true, from);
    rf_bus_carrier(&bus, source, false, to);
  }

  std::vector<board_config> boards;
  std::vector<fault_config> faults;
  rf_bus bus;
  std::vector<std::vector<Level>> levels;
  std::vector<std::pair<size_t, uint64_t>> collisions;
};

const cycles_t BIT = 8000;

}  // namespace

TEST(RfBus, a_carrier_reaches_the_boards_in_range_after_the_delay_and_not_its_own) {
  Air air(4, 20);
  air.pulse(0, 1000, 9000);
  rf_bus_advance(&air.bus, 100000);
  std::vector<Level> expected = {{true, 1000 + RF_DELAY}, {false, 9000 + RF_DELAY}};
  EXPECT_TRUE(air.levels[0].empty());
  EXPECT_EQ(air.levels[1], expected);
  EXPECT_EQ(air.levels[2], expected);  // exactly at the range
  EXPECT_TRUE(air.levels[3].empty());
}

TEST(RfBus, edges_may_come_in_any_order) {
  Air air(3, 100);
  air.pulse(1, 5000, 6000);
  air.pulse(0, 1000, 2000);
  rf_bus_advance(&air.bus, 100000);
  std::vector<Level> expected = {
      {true, 1000 + RF_DELAY}, {false, 2000 + RF_DELAY}, {true, 5000 + RF_DELAY}, {false, 6000 + RF_DELAY}};
  EXPECT_EQ(air.levels[2], expected);
}

TEST(RfBus, edges_after_the_advance_wait) {
  Air air(2, 100);
  air.pulse(0, 1000, 5000);
  rf_bus_advance(&air.bus, 5000);
  EXPECT_EQ(air.levels[1].size(), 1u);
  rf_bus_advance(&air.bus, 5001);
  EXPECT_EQ(air.levels[1].size(), 2u);
}

TEST(RfBus, two_carriers_are_heard_as_one_and_collide) {
  Air air(3, 100);
  air.pulse(0, 1000, 9000);
  air.pulse(1, 5000, 13000);
  rf_bus_advance(&air.bus, 200000);
  std::vector<Level> expected = {{true, 1000 + RF_DELAY}, {false, 13000 + RF_DELAY}};
  EXPECT_EQ(air.levels[2], expected);
  ASSERT_EQ(air.collisions.size(), 1u);  // at board 2 only: the others hear just one
  EXPECT_EQ(air.collisions[0], std::make_pair(size_t{2}, uint64_t{3}));
}

TEST(RfBus, transmissions_one_after_the_other_do_not_collide) {
  Air air(3, 100);
  air.pulse(0, 1000, 9000);
  air.pulse(1, 9000 + (RF_QUIET_BITS + 1) * BIT, 9000 + (RF_QUIET_BITS + 2) * BIT);
  rf_bus_advance(&air.bus, 1000000);
  EXPECT_TRUE(air.collisions.empty());
}

TEST(RfBus, boards_out_of_each_others_range_collide_between_them) {
  Air air(3, 10);
  air.pulse(0, 1000, 9000);
  air.pulse(2, 2000, 8000);
  rf_bus_advance(&air.bus, 200000);
  ASSERT_EQ(air.collisions.size(), 1u);
  EXPECT_EQ(air.collisions[0].first, 1u);
}

static std::vector<std::vector<Level>> with_errors(double rate, uint64_t seed) {
  Air air(3, 100, rate, seed);
  for (int i = 0; i < 200; i++) air.pulse(0, 1000 + 2 * BIT * i, 1000 + 2 * BIT * i + BIT);
  rf_bus_advance(&air.bus, 1000 + 500 * BIT);
  return air.levels;
}

TEST(RfBus, errors_repeat_by_seed_and_are_each_receivers_own) {
  EXPECT_EQ(with_errors(0.05, 1), with_errors(0.05, 1));
  EXPECT_NE(with_errors(0.05, 1), with_errors(0.05, 2));
  auto levels = with_errors(0.05, 1);
  EXPECT_NE(levels[1], levels[2]);
}

TEST(RfBus, errors_invert_whole_slots_at_the_rate_asked_for) {
  EXPECT_EQ(with_errors(0, 1)[1].size(), 400u);
  // All slots wrong: the signal comes inverted, and ends inverted back.
  auto inverted = with_errors(1, 1)[1];
  EXPECT_EQ(inverted[0], (Level{true, 1000 + BIT + RF_DELAY}));
  // Each wrong slot among alternating bits takes two edges away.
  size_t edges = 0;
  for (uint64_t seed = 0; seed < 50; seed++) edges += with_errors(0.01, seed)[1].size();
  EXPECT_NEAR(static_cast<double>(edges), 50 * (400 - 2 * 400 * 0.01), 150);
}

TEST(RfBus, silence_has_no_errors) {
  Air air(2, 100, 0.5);
  rf_bus_advance(&air.bus, 100000000);
  EXPECT_TRUE(air.levels[1].empty());
}

TEST(RfBus, a_jammer_is_heard_where_it_is_and_stops) {
  fault_config jam = {};
  jam.kind = FAULT_JAM;
  jam.has_position = true;
  jam.x_m = 30;
  Air air(4, 10, 0, 1, {jam});
  rf_bus_jam(&air.bus, 0, 5000, 5000 + 100 * BIT);
  rf_bus_advance(&air.bus, 5000 + 200 * BIT);
  EXPECT_TRUE(air.levels[0].empty());
  EXPECT_TRUE(air.levels[1].empty());
  EXPECT_GT(air.levels[2].size(), 20u);
  EXPECT_EQ(air.levels[2], air.levels[3]);
  EXPECT_FALSE(air.levels[3].back().level);
  EXPECT_LE(air.levels[3].back().at, 5000 + 100 * BIT + RF_DELAY);
  EXPECT_EQ(air.bus.next_event, NEVER);
}

static fault_config jam_at(double t_s, double x_m) {
  fault_config jam = {};
  jam.kind = FAULT_JAM;
  jam.t_s = t_s;
  jam.duration_s = 0.5;
  jam.has_position = true;
  jam.x_m = x_m;
  return jam;
}

TEST(RfBus, jams_one_after_the_other_are_heard_each_where_it_is) {
  std::vector<fault_config> jams;
  for (int i = 0; i < 200; i++) jams.push_back(jam_at(i, 30.0 * (i % 2)));
  Air air(4, 10, 0, 1, jams);
  EXPECT_EQ(air.bus.source_count, 6u);
  for (size_t i = 0; i < jams.size(); i++) {
    for (auto &levels : air.levels) levels.clear();
    cycles_t begin = seconds_to_cycles(jams[i].t_s);
    rf_bus_jam(&air.bus, i, begin, begin + seconds_to_cycles(0.5));
    rf_bus_advance(&air.bus, begin + seconds_to_cycles(1));
    for (size_t r = 0; r < 4; r++)
      EXPECT_EQ(air.levels[r].size() > 100, r / 2 == i % 2) << "jam " << i << ", receiver " << r;
  }
}

TEST(RfBus, as_many_jams_at_one_time_as_there_are_sources) {
  std::vector<board_config> boards(32);
  std::vector<fault_config> jams;
  for (int i = 0; i < 31; i++) jams.push_back(jam_at(i * 0.01, 0));
  rf_bus bus;
  scenario config = {{2000, 10, 0}, boards.data(), boards.size(), jams.data(), jams.size(), {}};
  EXPECT_EQ(rf_bus_init(&bus, &config, 1, {}), 0);
  rf_bus_release(&bus);
  jams.push_back(jam_at(0.4, 0));
  config.faults = jams.data();
  config.fault_count = jams.size();
  EXPECT_EQ(rf_bus_init(&bus, &config, 1, {}), -1);
  rf_bus_release(&bus);
}

TEST(RfBus, who_hears_whom_follows_moves_and_the_range_even_in_the_middle_of_a_carrier) {
  Air air(2, 20);
  rf_bus_carrier(&air.bus, 0, true, 1000);
  rf_bus_advance(&air.bus, 5000);
  rf_bus_move(&air.bus, 1, 30, 0, 5000);
  rf_bus_advance(&air.bus, 6000);
  rf_bus_set_range(&air.bus, 30, 6000);
  rf_bus_advance(&air.bus, 7000);
  rf_bus_move(&air.bus, 0, -1, 0, 7000);
  rf_bus_advance(&air.bus, 8000);
  std::vector<Level> expected = {
      {true, 1000 + RF_DELAY}, {false, 5000 + RF_DELAY}, {true, 6000 + RF_DELAY}, {false, 7000 + RF_DELAY}};
  EXPECT_EQ(air.levels[1], expected);
}

TEST(RfBus, errors_end_when_their_rate_is_set_to_none) {
  Air air(2, 20, 1);
  rf_bus_carrier(&air.bus, 0, true, 1000);
  rf_bus_advance(&air.bus, 1000 + 2 * BIT);
  rf_bus_set_errors(&air.bus, 0, 1000 + 2 * BIT);
  rf_bus_carrier(&air.bus, 0, false, 1000 + 4 * BIT);
  rf_bus_advance(&air.bus, 1000 + 40 * BIT);
  std::vector<Level> expected = {{true, 1000 + 2 * BIT + RF_DELAY}, {false, 1000 + 4 * BIT + RF_DELAY}};
  EXPECT_EQ(air.levels[1], expected);
  EXPECT_EQ(air.bus.next_event, NEVER);
}
