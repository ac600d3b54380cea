#include <delivery/Backoff.h>
#include <delivery/MediumAccess.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using javinolib::Backoff;
using javinolib::MediumAccess;
using javinolib::Random;

namespace {

// The quiet slot in which a wait that began at `quiet` slots is over.
int slotsFrom(uint8_t quiet, uint8_t attempt, Random &random) {
  Backoff backoff;
  backoff.begin(attempt, quiet, random);
  int slots = quiet;
  for (uint8_t slot = quiet; !backoff.isOver(slot); slot = MediumAccess::slotAfter(slot)) slots++;
  return slots;
}

std::set<int> allFrom(uint8_t quiet, uint8_t attempt) {
  Random random;
  random.seed(1, 1);
  std::set<int> seen;
  for (int i = 0; i < 20000; i++) seen.insert(slotsFrom(quiet, attempt, random));
  return seen;
}

// Lets the air be quiet for so many slots, and then busy, so many times.
void hear(Backoff &backoff, uint8_t quietSlots, int times) {
  for (; times > 0; times--) {
    for (uint8_t quiet = 0; quiet <= quietSlots; quiet++) backoff.listen(quiet);
    backoff.listen(0);
  }
}

// The most slots beyond the first 6 that a wait takes.
int longest(Backoff backoff, uint8_t attempt = 0) {
  Random random;
  random.seed(1, 1);
  int most = 0;
  for (int i = 0; i < 20000; i++) {
    backoff.begin(attempt, 0, random);
    int slots = 0;
    for (uint8_t slot = 6; !backoff.isOver(slot); slot = MediumAccess::slotAfter(slot)) slots++;
    most = std::max(most, slots);
  }
  return most;
}

}  // namespace

TEST(Backoff, what_is_new_goes_at_once_after_15_quiet_slots_and_not_before) {
  EXPECT_EQ(std::set<int>{15}, allFrom(15, 0));
  EXPECT_EQ(16u, allFrom(14, 0).size());
}

TEST(Backoff, waits_6_quiet_slots_and_as_many_as_the_attempt_says) {
  const size_t windows[] = {16, 32, 64, 128, 128, 128, 128, 128};
  for (uint8_t attempt = 0; attempt < 8; attempt++) {
    const std::set<int> seen = allFrom(0, attempt);
    EXPECT_EQ(windows[attempt], seen.size()) << int(attempt);
    EXPECT_EQ(6, *seen.begin());
    EXPECT_EQ(static_cast<int>(5 + windows[attempt]), *seen.rbegin());
  }
}

TEST(Backoff, window_grows_by_an_eighth_where_others_begin_after_few_idle_slots_up_to_256) {
  for (uint8_t idle : {0, 1, 2}) {
    Backoff backoff;
    hear(backoff, static_cast<uint8_t>(6 + idle), 1);
    EXPECT_EQ(17, longest(backoff)) << int(idle);
    hear(backoff, static_cast<uint8_t>(6 + idle), 1);
    EXPECT_EQ(19, longest(backoff)) << int(idle);
    hear(backoff, static_cast<uint8_t>(6 + idle), 100);
    EXPECT_EQ(255, longest(backoff)) << int(idle);
  }
}

TEST(Backoff, window_shrinks_by_an_eighth_where_more_slots_stay_idle_down_to_16) {
  for (uint8_t idle : {3, 10, 200}) {
    Backoff backoff;
    hear(backoff, 6, 8);  // 16 * (9 / 8)^8 = 41, but for rounding
    EXPECT_EQ(39, longest(backoff));
    hear(backoff, static_cast<uint8_t>(6 + idle), 1);
    EXPECT_EQ(34, longest(backoff)) << int(idle);
    hear(backoff, static_cast<uint8_t>(6 + idle), 100);
    EXPECT_EQ(15, longest(backoff)) << int(idle);
  }
}

TEST(Backoff, window_stays_where_an_acknowledgement_follows_and_while_the_air_is_quiet_or_busy) {
  Backoff backoff;
  hear(backoff, 6, 8);
  for (uint8_t quiet = 0; quiet < 6; quiet++) hear(backoff, quiet, 50);
  for (int slots = 0; slots <= 255; slots++) backoff.listen(static_cast<uint8_t>(slots));
  for (int i = 0; i < 1000; i++) backoff.listen(255);
  EXPECT_EQ(39, longest(backoff));
}

TEST(Backoff, no_wait_is_longer_than_256_slots_however_many_attempts) {
  Backoff backoff;
  hear(backoff, 6, 12);  // 16 * (9 / 8)^12 = 66, but for rounding
  EXPECT_EQ(129, longest(backoff, 1));
  EXPECT_EQ(255, longest(backoff, 7));
}

TEST(Backoff, waits_for_a_random_time_however_long_the_air_was_quiet) {
  EXPECT_EQ(64u, allFrom(255, 2).size());
  EXPECT_EQ(64u, allFrom(250, 2).size());
}

TEST(Backoff, window_stays_where_the_count_of_quiet_slots_goes_round) {
  Backoff backoff;
  hear(backoff, 6, 8);
  uint8_t slot = 0;
  for (int i = 0; i < 1000; i++) backoff.listen(slot = MediumAccess::slotAfter(slot));
  EXPECT_EQ(39, longest(backoff));
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
