#include <delivery/Backoff.h>
#include <gtest/gtest.h>

#include <set>

using javino::Backoff;
using javino::Random;

namespace {

// The quiet slot in which a wait that began at `quiet` slots is over.
int slotsFrom(uint8_t quiet, uint8_t attempt, Random &random) {
  Backoff backoff;
  backoff.begin(attempt, quiet, random);
  int slots = quiet;
  while (!backoff.isOver(static_cast<uint8_t>(slots))) slots++;
  return slots;
}

std::set<int> allFrom(uint8_t quiet, uint8_t attempt) {
  Random random;
  random.seed(1, 1);
  std::set<int> seen;
  for (int i = 0; i < 5000; i++) seen.insert(slotsFrom(quiet, attempt, random));
  return seen;
}

}  // namespace

TEST(Backoff, what_is_new_goes_at_once_after_15_quiet_slots_and_not_before) {
  EXPECT_EQ(std::set<int>{15}, allFrom(15, 0));
  EXPECT_EQ(16u, allFrom(14, 0).size());
}

TEST(Backoff, waits_6_quiet_slots_and_as_many_as_the_attempt_says) {
  const size_t windows[] = {16, 32, 32, 32, 32, 32, 32, 32};
  for (uint8_t attempt = 0; attempt < 8; attempt++) {
    const std::set<int> seen = allFrom(0, attempt);
    EXPECT_EQ(windows[attempt], seen.size()) << int(attempt);
    EXPECT_EQ(6, *seen.begin());
    EXPECT_EQ(static_cast<int>(5 + windows[attempt]), *seen.rbegin());
  }
}

TEST(Backoff, counts_on_after_each_carrier_and_its_6_slots) {
  Random random;
  random.seed(2, 7);
  for (int i = 0; i < 100; i++) {
    Random same = random;
    const int whole = slotsFrom(0, 3, same) - 6;
    Backoff backoff;
    backoff.begin(3, 0, random);
    int counted = 0;
    for (bool over = false; !over;) {
      for (uint8_t quiet = 0; quiet <= 9 && !over; quiet++) {
        over = backoff.isOver(quiet);
        if (quiet > 6) counted++;
      }
    }
    EXPECT_EQ(whole, counted) << "3 slots of each quiet of 9 count";
  }
}
