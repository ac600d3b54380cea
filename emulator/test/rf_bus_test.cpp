// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <algorithm>
#include <cmath>
#include <set>

extern "C" {
#include "rf_bus.h"
}

namespace {

struct Level {
  bool level;
  cycles_t at;
  bool operator==(const Level &other) const { return level == other.level && at == other.at; }
};

radio_config radio_of(double range_m, double errors = 0) {
  radio_config radio = {};
  radio.bit_rate = 2000;
  radio.range_m = range_m;
  radio.bit_error_rate = errors;
  return radio;
}

// A bus of boards on a line, one every 10 m.
struct Air {
  Air(size_t count, double range_m, double errors = 0, uint64_t seed = 1, std::vector<fault_config> jams = {})
      : Air(count, radio_of(range_m, errors), seed, jams) {}
  Air(size_t count, const radio_config &radio, uint64_t seed = 1, std::vector<fault_config> jams = {})
      : boards(count), faults(jams), levels(count) {
    for (size_t i = 0; i < count; i++) boards[i].x_m = 10.0 * static_cast<double>(i);
    scenario config = {radio, boards.data(), count, faults.data(), faults.size(), {}};
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

  void set(const radio_config &radio, cycles_t at) { rf_bus_set_radio(&bus, &radio, at); }

  // The level at a receiver in the middle of each of so many bits from `from` on.
  std::vector<bool> bits(size_t receiver, cycles_t from, size_t count) const {
    std::vector<bool> found(count);
    size_t next = 0;
    bool level = false;
    for (size_t i = 0; i < count; i++) {
      for (; next < levels[receiver].size() && levels[receiver][next].at <= from + RF_DELAY + i * BIT + BIT / 2; next++)
        level = levels[receiver][next].level;
      found[i] = level;
    }
    return found;
  }

  std::vector<board_config> boards;
  std::vector<fault_config> faults;
  rf_bus bus;
  std::vector<std::vector<Level>> levels;
  std::vector<std::pair<size_t, uint64_t>> collisions;
};

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
  scenario config = {radio_of(10), boards.data(), boards.size(), jams.data(), jams.size(), {}};
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
  air.set(radio_of(30), 6000);
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
  air.set(radio_of(20), 1000 + 2 * BIT);
  rf_bus_carrier(&air.bus, 0, false, 1000 + 4 * BIT);
  rf_bus_advance(&air.bus, 1000 + 40 * BIT);
  std::vector<Level> expected = {{true, 1000 + 2 * BIT + RF_DELAY}, {false, 1000 + 4 * BIT + RF_DELAY}};
  EXPECT_EQ(air.levels[1], expected);
  EXPECT_EQ(air.bus.next_event, NEVER);
}

namespace {

// The places of the wrong bits that a receiver gets of a long carrier from its neighbour.
std::vector<size_t> errors_in(Air &air, size_t receiver, size_t bits) {
  rf_bus_carrier(&air.bus, receiver - 1, true, 1000);
  rf_bus_advance(&air.bus, 1000 + bits * BIT);
  std::vector<size_t> places;
  auto levels = air.bits(receiver, 1000, bits);
  for (size_t i = 0; i < bits; i++)
    if (!levels[i]) places.push_back(i);
  return places;
}

radio_config with_bursts(double rate, double length, double within) {
  radio_config radio = radio_of(100);
  radio.bursts = {rate, length, within};
  return radio;
}

}  // namespace

TEST(RfBus, errors_in_bursts_have_the_mean_rate_the_length_and_the_rate_within) {
  const size_t BITS = 400000;
  Air air(3, with_bursts(0.01, 30, 0.25));
  auto errors = errors_in(air, 1, BITS);
  EXPECT_NEAR(static_cast<double>(errors.size()) / BITS, 0.01, 0.0012);
  // A bit after a wrong one: the n-th is in the same burst by exp(-n / 30), and then wrong by 0.25.
  for (size_t n : {1u, 10u, 30u, 300u}) {
    std::set<size_t> places(errors.begin(), errors.end());
    double both = 0;
    for (size_t place : errors) both += places.count(place + n);
    double in_burst = 0.04 + 0.96 * std::exp(-static_cast<double>(n) / (30 * 0.96));
    EXPECT_NEAR(both / static_cast<double>(errors.size()), 0.25 * in_burst, 0.03) << n;
  }
}

TEST(RfBus, bursts_repeat_by_seed_and_are_each_receivers_own) {
  auto errors = [](uint64_t seed, size_t receiver) {
    Air air(3, with_bursts(0.02, 30, 0.25), seed);
    return errors_in(air, receiver, 5000);
  };
  EXPECT_EQ(errors(1, 1), errors(1, 1));
  EXPECT_NE(errors(1, 1), errors(2, 1));
  EXPECT_NE(errors(1, 1), errors(1, 2));
}

TEST(RfBus, bursts_leave_the_independent_errors_where_they_are) {
  radio_config both = with_bursts(0.01, 30, 1);
  both.bit_error_rate = 0.01;
  Air alone(2, 100, 0.01), mixed(2, both), bursts(2, with_bursts(0.01, 30, 1));
  auto independent = errors_in(alone, 1, 5000), in_bursts = errors_in(bursts, 1, 5000);
  std::vector<size_t> expected;
  std::set_symmetric_difference(independent.begin(), independent.end(), in_bursts.begin(), in_bursts.end(),
                                std::back_inserter(expected));
  EXPECT_FALSE(independent.empty());
  EXPECT_FALSE(in_bursts.empty());
  EXPECT_EQ(errors_in(mixed, 1, 5000), expected);
}

TEST(RfBus, errors_by_distance_are_those_of_the_best_sender_that_is_heard) {
  radio_config radio = radio_of(100);
  radio.distance_rates[0] = {10, 0};
  radio.distance_rates[1] = {20, 1};
  radio.distance_rate_count = 2;
  Air air(4, radio);
  rf_bus_carrier(&air.bus, 0, true, 1000);
  rf_bus_advance(&air.bus, 1000 + 100 * BIT);
  EXPECT_EQ(air.bits(1, 1000, 100), std::vector<bool>(100, true));
  EXPECT_EQ(air.bits(2, 1000, 100), std::vector<bool>(100, false));  // 20 m: each bit is wrong
  rf_bus_carrier(&air.bus, 3, true, 1000 + 100 * BIT);
  rf_bus_advance(&air.bus, 1000 + 200 * BIT);
  EXPECT_EQ(air.bits(2, 1000 + 101 * BIT, 90), std::vector<bool>(90, true));  // 10 m from the other one
}

TEST(RfBus, errors_by_distance_come_on_top_of_the_independent_ones) {
  radio_config radio = radio_of(100, 1);
  radio.distance_rates[0] = {10, 0};
  radio.distance_rates[1] = {20, 1};
  radio.distance_rate_count = 2;
  Air air(3, radio);
  rf_bus_carrier(&air.bus, 0, true, 1000);
  rf_bus_advance(&air.bus, 1000 + 100 * BIT);
  EXPECT_EQ(air.bits(1, 1000, 100), std::vector<bool>(100, false));
  EXPECT_EQ(air.bits(2, 1000, 100), std::vector<bool>(100, true));  // wrong twice is right
}

TEST(RfBus, errors_by_distance_follow_moves) {
  radio_config radio = radio_of(100);
  radio.distance_rates[0] = {10, 0};
  radio.distance_rates[1] = {20, 1};
  radio.distance_rate_count = 2;
  Air air(2, radio);
  rf_bus_carrier(&air.bus, 0, true, 1000);
  rf_bus_advance(&air.bus, 1000 + 10 * BIT);
  rf_bus_move(&air.bus, 1, 20, 0, 1000 + 10 * BIT);
  rf_bus_advance(&air.bus, 1000 + 30 * BIT);
  auto bits = air.bits(1, 1000, 30);
  EXPECT_EQ(std::vector<bool>(bits.begin(), bits.begin() + 10), std::vector<bool>(10, true));
  EXPECT_EQ(std::vector<bool>(bits.begin() + 12, bits.end()), std::vector<bool>(18, false));
}

TEST(RfBus, shadowing_reaches_as_far_in_one_direction_as_in_the_other) {
  radio_config radio = radio_of(25);
  radio.shadowing_db = 8;
  size_t beyond = 0, short_of = 0;
  for (uint64_t seed = 0; seed < 20; seed++) {
    Air air(6, radio, seed);
    for (size_t a = 0; a < 6; a++) {
      for (size_t b = 0; b < a; b++) {
        EXPECT_EQ(rf_bus_hears(&air.bus, a, b), rf_bus_hears(&air.bus, b, a));
        beyond += a - b > 2 && rf_bus_hears(&air.bus, a, b);
        short_of += a - b <= 2 && !rf_bus_hears(&air.bus, a, b);
      }
    }
  }
  EXPECT_GT(beyond, 20u);
  EXPECT_GT(short_of, 20u);
}

static radio_config noisy(double edges_per_s, double after_s) {
  radio_config radio = radio_of(100);
  radio.noise = {edges_per_s, after_s};
  return radio;
}

TEST(RfBus, a_receiver_that_hears_nobody_for_long_enough_gives_noise) {
  Air air(2, noisy(2000, 0.2));
  rf_bus_advance(&air.bus, seconds_to_cycles(10.2));
  ASSERT_FALSE(air.levels[0].empty());
  EXPECT_GE(air.levels[0][0].at, seconds_to_cycles(0.2) + RF_DELAY);
  EXPECT_LT(air.levels[0][0].at, seconds_to_cycles(0.21));
  EXPECT_NEAR(static_cast<double>(air.levels[0].size()), 20000, 500);
  EXPECT_NE(air.levels[0], air.levels[1]);
  Air again(2, noisy(2000, 0.2)), other(2, noisy(2000, 0.2), 2);
  rf_bus_advance(&again.bus, seconds_to_cycles(10.2));
  rf_bus_advance(&other.bus, seconds_to_cycles(10.2));
  EXPECT_EQ(again.levels, air.levels);
  EXPECT_NE(other.levels, air.levels);
}

TEST(RfBus, noise_ends_with_the_first_carrier_and_comes_back_after_the_last) {
  Air air(2, noisy(5000, 0.1));
  cycles_t begin = seconds_to_cycles(1), end = begin + 50 * BIT;
  for (int i = 0; i < 25; i++) air.pulse(0, begin + 2 * BIT * i, begin + 2 * BIT * i + BIT);
  rf_bus_advance(&air.bus, seconds_to_cycles(2));
  size_t before = 0, meanwhile = 0, gap = 0, after = 0;
  for (const Level &each : air.levels[1]) {
    cycles_t at = each.at - RF_DELAY;
    (at < begin ? before : at < end ? meanwhile : at < end + seconds_to_cycles(0.1) ? gap : after)++;
  }
  EXPECT_GT(before, 1000u);
  EXPECT_NEAR(static_cast<double>(meanwhile), 50, 1);  // the first edge is there already where noise was high
  EXPECT_EQ(gap, 0u);
  EXPECT_GT(after, 1000u);
}

TEST(RfBus, who_sends_has_no_noise_for_as_long_after_it) {
  Air air(2, noisy(5000, 0.1));
  cycles_t begin = seconds_to_cycles(1), end = begin + 49 * BIT;
  for (int i = 0; i < 25; i++) air.pulse(0, begin + 2 * BIT * i, begin + 2 * BIT * i + BIT);
  rf_bus_advance(&air.bus, seconds_to_cycles(2));
  size_t quiet = 0, after = 0;
  for (const Level &each : air.levels[0]) {
    quiet += each.at > begin + RF_DELAY && each.at < end + seconds_to_cycles(0.1);
    after += each.at > end + seconds_to_cycles(0.1);
  }
  EXPECT_EQ(quiet, 0u);
  EXPECT_GT(after, 1000u);
}

TEST(RfBus, noise_that_is_switched_off_ends) {
  Air air(2, noisy(5000, 0));
  rf_bus_advance(&air.bus, seconds_to_cycles(1));
  for (auto &levels : air.levels) levels.clear();
  air.set(radio_of(100), seconds_to_cycles(1));
  rf_bus_advance(&air.bus, seconds_to_cycles(2));
  for (const auto &levels : air.levels) EXPECT_LE(levels.size(), 1u);
  EXPECT_EQ(air.bus.next_event, NEVER);
}

// Boards at 0, 10 and 20 m hear each other; board 1 moves to where `from_m` tells, and hears the outer two.
static std::vector<Level> heard_between(double from_m, double capture_db, std::vector<fault_config> jams = {}) {
  radio_config radio = radio_of(100);
  radio.capture_db = capture_db;
  Air air(3, radio, 1, jams);
  rf_bus_move(&air.bus, 1, from_m, 0, 0);
  if (!jams.empty()) rf_bus_jam(&air.bus, 0, 2000, 900 * BIT);
  air.pulse(0, 1000, 1000 + 3 * BIT);
  air.pulse(2, 1000 + BIT, 1000 + 6 * BIT);
  rf_bus_advance(&air.bus, 1000 * BIT);
  EXPECT_GE(air.collisions.size(), 1u);
  return air.levels[1];
}

TEST(RfBus, the_sender_that_is_so_much_stronger_is_heard_alone) {
  const std::vector<Level> both = {{true, 1000 + RF_DELAY}, {false, 1000 + 6 * BIT + RF_DELAY}};
  // The first one alone, until it is over for good.
  const std::vector<Level> first = {{true, 1000 + RF_DELAY}, {false, 1000 + 3 * BIT + RF_DELAY}};
  EXPECT_EQ(heard_between(7, 0), both);
  EXPECT_EQ(heard_between(7, 9), both);
  EXPECT_EQ(heard_between(7, 8), first);  // 13 m against 7: 8.07 dB
  EXPECT_EQ(heard_between(10, 1), both);
  EXPECT_EQ(heard_between(13, 8), both);  // the later one has a carrier all the time
}

TEST(RfBus, a_stronger_sender_takes_over_from_a_weaker_one) {
  radio_config radio = radio_of(100);
  radio.capture_db = 6;
  Air air(3, radio);
  rf_bus_move(&air.bus, 1, 18, 0, 0);
  rf_bus_carrier(&air.bus, 0, true, 1000);
  air.pulse(2, 1000 + 2 * BIT, 1000 + 3 * BIT);
  air.pulse(2, 1000 + 4 * BIT, 1000 + 5 * BIT);
  rf_bus_advance(&air.bus, 1000 + 100 * BIT);
  std::vector<bool> expected(30, true);
  // The weaker one is heard again when the stronger one has been silent for eight bits.
  for (size_t i : {3u, 5u, 6u, 7u, 8u, 9u, 10u, 11u, 12u}) expected[i] = false;
  EXPECT_EQ(air.bits(1, 1000, 30), expected);
}

TEST(RfBus, a_jam_that_is_everywhere_is_not_captured_by_a_board) {
  fault_config jam = jam_at(0, 0);
  jam.has_position = false;
  EXPECT_GT(heard_between(1, 20, {jam}).size(), 20u);
}
