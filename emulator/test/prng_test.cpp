// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

extern "C" {
#include "prng.h"
}

TEST(Prng, follows_the_published_definition) {
  // The first outputs of xoshiro256** from the state 1, 2, 3, 4.
  prng generator = {{1, 2, 3, 4}};
  EXPECT_EQ(prng_next(&generator), 11520u);
  EXPECT_EQ(prng_next(&generator), 0u);
  EXPECT_EQ(prng_next(&generator), 1509978240u);
  EXPECT_EQ(prng_next(&generator), 1215971899390074240u);
}

TEST(Prng, repeats_by_seed_and_differs_by_stream) {
  prng a, b, c;
  prng_seed(&a, 7, 0);
  prng_seed(&b, 7, 0);
  prng_seed(&c, 7, 1);
  for (int i = 0; i < 100; i++) {
    uint64_t number = prng_next(&a);
    EXPECT_EQ(number, prng_next(&b));
    EXPECT_NE(number, prng_next(&c));
  }
}

TEST(Prng, times_and_deviations_have_mean_and_spread) {
  prng generator;
  prng_seed(&generator, 1, 0);
  const int COUNT = 100000;
  double times = 0, longer = 0, sum = 0, squares = 0, beyond = 0;
  for (int i = 0; i < COUNT; i++) {
    double time = prng_exponential(&generator, 5), normal = prng_normal(&generator);
    times += time;
    longer += time > 10;
    sum += normal;
    squares += normal * normal;
    beyond += normal > 2;
  }
  EXPECT_NEAR(times / COUNT, 5, 0.05);
  EXPECT_NEAR(longer / COUNT, 0.135, 0.005);  // exp(-2)
  EXPECT_NEAR(sum / COUNT, 0, 0.01);
  EXPECT_NEAR(squares / COUNT, 1, 0.02);
  EXPECT_NEAR(beyond / COUNT, 0.0228, 0.002);
}

TEST(Prng, chance_hits_as_often_as_asked) {
  prng generator;
  prng_seed(&generator, 1, 0);
  int hits = 0;
  for (int i = 0; i < 100000; i++) hits += prng_chance(&generator, 0.25);
  EXPECT_NEAR(hits, 25000, 500);
  EXPECT_FALSE(prng_chance(&generator, 0));
  EXPECT_TRUE(prng_chance(&generator, 1));
}
