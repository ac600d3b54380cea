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

TEST(Backoff, what_is_new_goes_at_once_after_20_quiet_slots_and_not_before) {
  EXPECT_EQ(std::set<int>{20}, allFrom(20, 0));
  EXPECT_EQ(8u, allFrom(19, 0).size());
}

TEST(Backoff, waits_4_quiet_slots_and_as_many_as_the_attempt_says) {
  const size_t windows[] = {8, 16, 32, 64, 64, 64, 64, 64};
  for (uint8_t attempt = 0; attempt < 8; attempt++) {
    const std::set<int> seen = allFrom(0, attempt);
    EXPECT_EQ(windows[attempt], seen.size()) << int(attempt);
    EXPECT_EQ(4, *seen.begin());
    EXPECT_EQ(static_cast<int>(3 + windows[attempt]), *seen.rbegin());
  }
}

TEST(Backoff, counts_on_after_each_carrier_and_its_4_slots) {
  Random random;
  random.seed(2, 7);
  for (int i = 0; i < 100; i++) {
    Random same = random;
    const int whole = slotsFrom(0, 3, same) - 4;
    Backoff backoff;
    backoff.begin(3, 0, random);
    int counted = 0;
    for (bool over = false; !over;) {
      for (uint8_t quiet = 0; quiet <= 7 && !over; quiet++) {
        over = backoff.isOver(quiet);
        if (quiet > 4) counted++;
      }
    }
    EXPECT_EQ(whole, counted) << "3 slots of each quiet of 7 count";
  }
}
