// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <cmath>

extern "C" {
#include "propagation.h"
}

static radio_config with_table(std::vector<distance_rate> points) {
  radio_config radio = {};
  for (const distance_rate &point : points) radio.distance_rates[radio.distance_rate_count++] = point;
  return radio;
}

TEST(Propagation, the_rate_between_two_points_is_that_of_its_logarithm) {
  radio_config radio = with_table({{10, 1e-4}, {20, 1e-2}, {40, 0.5}});
  EXPECT_EQ(propagation_error_rate(&radio, 0), 1e-4);
  EXPECT_NEAR(propagation_error_rate(&radio, 10), 1e-4, 1e-12);
  EXPECT_NEAR(propagation_error_rate(&radio, 15), 1e-3, 1e-9);
  EXPECT_NEAR(propagation_error_rate(&radio, 20), 1e-2, 1e-9);
  EXPECT_NEAR(propagation_error_rate(&radio, 30), std::sqrt(0.005), 1e-9);
  EXPECT_EQ(propagation_error_rate(&radio, 41), 0.5);
}

TEST(Propagation, a_rate_of_none_rises_from_one_in_a_thousand_million) {
  radio_config radio = with_table({{0, 0}, {80, 0.1}, {90, 0}, {100, 0}});
  EXPECT_NEAR(propagation_error_rate(&radio, 0), 0, 1.1e-9);
  EXPECT_NEAR(propagation_error_rate(&radio, 40), 1e-5, 1e-9);
  EXPECT_NEAR(propagation_error_rate(&radio, 85), 1e-5, 1e-9);
  EXPECT_EQ(propagation_error_rate(&radio, 95), 0);
}

TEST(Propagation, without_a_table_there_are_no_errors) {
  radio_config radio = {};
  EXPECT_EQ(propagation_error_rate(&radio, 1e6), 0);
}

TEST(Propagation, shadowing_is_each_pairs_own_the_same_both_ways_and_repeats_by_seed) {
  radio_config radio = {};
  EXPECT_EQ(propagation_metres(&radio, 1, 0, 1, 50), 50);
  radio.shadowing_db = 4;
  EXPECT_EQ(propagation_metres(&radio, 1, 0, 1, 50), propagation_metres(&radio, 1, 1, 0, 50));
  EXPECT_NE(propagation_metres(&radio, 1, 0, 1, 50), propagation_metres(&radio, 1, 0, 2, 50));
  EXPECT_NE(propagation_metres(&radio, 1, 0, 1, 50), propagation_metres(&radio, 2, 0, 1, 50));
  EXPECT_DOUBLE_EQ(propagation_metres(&radio, 1, 0, 1, 100), 2 * propagation_metres(&radio, 1, 0, 1, 50));
}

TEST(Propagation, shadowing_has_the_standard_deviation_that_was_asked_for) {
  radio_config radio = {};
  radio.shadowing_db = 4;
  double sum = 0, squares = 0;
  int pairs = 0;
  for (size_t a = 0; a < 64; a++) {
    for (size_t b = 0; b < a; b++, pairs++) {
      double db = 30 * std::log10(propagation_metres(&radio, 1, a, b, 1));
      sum += db;
      squares += db * db;
    }
  }
  EXPECT_NEAR(sum / pairs, 0, 0.3);
  EXPECT_NEAR(std::sqrt(squares / pairs), 4, 0.2);
}

TEST(Propagation, nine_decibels_are_twice_the_distance) {
  radio_config radio = {};
  radio.capture_db = 9;
  EXPECT_NEAR(propagation_capture_ratio(&radio), 2, 0.01);
}
