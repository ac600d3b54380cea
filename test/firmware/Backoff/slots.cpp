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
    backoff.listen(1);
  }
}

// Slots from one on until the wait is over.
int further(Backoff backoff, uint8_t from = 6) {
  int slots = 0;
  for (uint8_t slot = from; !backoff.isOver(slot); slot = MediumAccess::slotAfter(slot)) slots++;
  return slots;
}

// The slots of all waits that begin at so many quiet slots beyond these, or the first 6.
std::set<int> all(Backoff backoff, uint8_t attempt = 0, uint8_t quietSlots = 0) {
  Random random;
  random.seed(1, 1);
  std::set<int> seen;
  for (int i = 0; i < 20000; i++) {
    backoff.begin(attempt, quietSlots, random);
    seen.insert(further(backoff, std::max<uint8_t>(6, quietSlots)));
  }
  return seen;
}

// The most slots beyond the first 6 that a wait takes.
int longest(const Backoff &backoff, uint8_t attempt = 0) { return *all(backoff, attempt).rbegin(); }

// Another device is acknowledged after so many quiet slots.
void answerOther(Backoff &backoff, uint8_t quietSlots) {
  Random random;
  backoff.listen(quietSlots);
  backoff.listen(0);
  backoff.otherAcknowledged(random);
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

TEST(Backoff, window_grows_by_an_eighth_where_others_begin_after_few_idle_slots_up_to_255) {
  for (uint8_t idle : {0, 1, 2}) {
    Backoff backoff;
    hear(backoff, static_cast<uint8_t>(6 + idle), 1);
    EXPECT_EQ(17, longest(backoff)) << int(idle);
    hear(backoff, static_cast<uint8_t>(6 + idle), 1);
    EXPECT_EQ(19, longest(backoff)) << int(idle);
    hear(backoff, static_cast<uint8_t>(6 + idle), 100);
    EXPECT_EQ(254, longest(backoff)) << int(idle);
  }
}

TEST(Backoff, window_shrinks_by_an_eighth_where_more_slots_stay_idle_down_to_16) {
  for (uint8_t idle : {3, 10, 200}) {
    Backoff backoff;
    hear(backoff, 6, 8);  // 16 * (9 / 8)^8 = 41, but for rounding
    EXPECT_EQ(40, longest(backoff));
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
  EXPECT_EQ(40, longest(backoff));
}

TEST(Backoff, no_wait_is_longer_than_255_slots_however_many_attempts) {
  Backoff backoff;
  hear(backoff, 6, 12);  // 16 * (9 / 8)^12 = 66, but for rounding
  EXPECT_EQ(129, longest(backoff, 1));
  EXPECT_EQ(254, longest(backoff, 7));
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
  EXPECT_EQ(40, longest(backoff));
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

TEST(Backoff, a_hidden_sender_is_known_by_an_acknowledgement_after_24_quiet_slots) {
  Backoff backoff;
  for (uint8_t quiet : {1, 23}) answerOther(backoff, quiet);
  EXPECT_EQ(31, longest(backoff, 1)) << "what it answers was heard";
  answerOther(backoff, 24);
  EXPECT_EQ(63, longest(backoff, 1));
}

TEST(Backoff, where_one_is_known_the_window_grows_fourfold_up_to_255) {
  Backoff backoff;
  answerOther(backoff, 30);
  const int most[] = {15, 63, 254, 254, 254, 254, 254, 254};
  for (uint8_t attempt = 0; attempt < 8; attempt++) EXPECT_EQ(most[attempt], longest(backoff, attempt)) << int(attempt);
}

TEST(Backoff, what_waits_goes_within_8_slots_after_the_acknowledgement_of_a_hidden_senders_packet) {
  Random random;
  random.seed(1, 1);
  std::set<int> seen;
  for (int i = 0; i < 1000; i++) {
    Backoff backoff;
    backoff.begin(7, 0, random);
    backoff.listen(30);
    backoff.listen(0);
    backoff.otherAcknowledged(random);
    seen.insert(further(backoff));
  }
  EXPECT_EQ((std::set<int>{0, 1, 2, 3, 4, 5, 6, 7}), seen);
}

TEST(Backoff, what_is_new_yields_for_80_slots_after_our_own_until_the_hidden_sender_is_acknowledged) {
  Backoff backoff;
  answerOther(backoff, 30);
  backoff.acknowledged();
  EXPECT_EQ(80, *all(backoff).begin());
  EXPECT_EQ(95, longest(backoff));
  EXPECT_EQ(40, *all(backoff, 0, 40).begin()) << "half of them have passed";
  EXPECT_EQ(std::set<int>{0}, all(backoff, 0, 80)) << "all have";
  EXPECT_EQ(0, *all(backoff, 1).begin()) << "it is not new";
  answerOther(backoff, 30);
  EXPECT_EQ(0, *all(backoff).begin());
}

TEST(Backoff, it_is_known_for_8_unicasts_that_are_acknowledged) {
  Backoff backoff;
  answerOther(backoff, 30);
  for (int i = 1; i < 8; i++) {
    backoff.acknowledged();
    EXPECT_EQ(95, longest(backoff)) << i;
  }
  backoff.acknowledged();
  EXPECT_EQ(15, longest(backoff));
  EXPECT_EQ(31, longest(backoff, 1));
}
