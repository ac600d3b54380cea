#include <gtest/gtest.h>
#include <support/Random.h>

#include <array>
#include <set>

using javinolib::Random;

TEST(Random, boards_and_boots_begin_differently) {
  std::set<std::array<uint16_t, 4>> sequences;
  for (uint32_t id = 0; id < 20; id++) {
    for (uint32_t epoch = 1; epoch <= 20; epoch++) {
      Random random;
      random.seed(0x480000 + id, epoch);
      sequences.insert({random.next(63), random.next(63), random.next(63), random.next(63)});
    }
  }
  EXPECT_EQ(400u, sequences.size());
}

TEST(Random, no_number_is_preferred) {
  Random random;
  random.seed(1, 1);
  std::array<int, 8> counts{};
  for (int i = 0; i < 65535; i++) counts[random.next(7)]++;
  for (int count : counts) EXPECT_NEAR(8192, count, 2);
}
