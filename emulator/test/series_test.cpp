// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

extern "C" {
#include "series.h"
}

static series_point points[] = {{1, 10}, {3, 30}, {4, 0}};
static const series VALUES = {points, 3};

TEST(Series, linear_lies_between_the_points) {
  EXPECT_DOUBLE_EQ(series_linear(&VALUES, 0), 10);
  EXPECT_DOUBLE_EQ(series_linear(&VALUES, 1), 10);
  EXPECT_DOUBLE_EQ(series_linear(&VALUES, 2), 20);
  EXPECT_DOUBLE_EQ(series_linear(&VALUES, 3), 30);
  EXPECT_DOUBLE_EQ(series_linear(&VALUES, 3.5), 15);
  EXPECT_DOUBLE_EQ(series_linear(&VALUES, 99), 0);
}

TEST(Series, step_holds_each_value_until_the_next_point) {
  EXPECT_DOUBLE_EQ(series_step(&VALUES, 0), 10);
  EXPECT_DOUBLE_EQ(series_step(&VALUES, 2.99), 10);
  EXPECT_DOUBLE_EQ(series_step(&VALUES, 3), 30);
  EXPECT_DOUBLE_EQ(series_step(&VALUES, 4), 0);
}

TEST(Series, next_change_is_the_next_point) {
  EXPECT_DOUBLE_EQ(series_next_change_s(&VALUES, 0), 1);
  EXPECT_DOUBLE_EQ(series_next_change_s(&VALUES, 1), 3);
  EXPECT_TRUE(std::isinf(series_next_change_s(&VALUES, 4)));
}
