#include <gtest/gtest.h>

#include "support/Addresses.h"
#include "support/ReplayRig.h"

using javinolib::Address;
using javinolib::ReplayMemory;

namespace {

const Address GROUP = Address(0xFFF001);
const Address OTHER_GROUP = Address(0xFFF002);
const uint8_t ENTRIES = javinolib::config::REPLAY_ENTRIES;

// Keys for the pairs 0…3 and two groups, in the places 4 and 5.
struct Rig : ReplayRig {
  Rig() {
    keys.set(GROUP, Bytes(16, 8).data());
    group = keys.current(GROUP);
  }

  // An insider of a group speaks as whoever he likes; returns how many he was taken for.
  int flood(uint8_t key) {
    int taken = 0;
    for (uint32_t origin = 1000; origin < 1200; origin++) taken += take(key, Address(origin), nonce(1, origin));
    return taken;
  }

  uint8_t group;
};

}  // namespace

TEST(ReplayShares, invented_origins_of_a_group_leave_each_pair_its_place) {
  Rig rig;
  EXPECT_EQ(ENTRIES - 4, rig.flood(rig.group));
  for (int boots = 0; boots < 3; boots++) {
    EXPECT_EQ(ReplayMemory::FULL, rig.judge(rig.group, SUPO, nonce(9, 9)));
    EXPECT_FALSE(rig.reserve(rig.group, SUPO, nonce(9, 9)));
    for (uint8_t pair = 0; pair < 4; pair++)
      EXPECT_TRUE(rig.take(pair, Address(pair), nonce(9 + boots, 0))) << int(pair);
    rig.powerCycle();
  }
}

TEST(ReplayShares, of_two_groups_each_has_half_of_what_pairs_leave) {
  Rig rig;
  rig.keys.set(OTHER_GROUP, Bytes(16, 9).data());
  EXPECT_EQ((ENTRIES - 4) / 2, rig.flood(rig.group));
  EXPECT_EQ((ENTRIES - 4) / 2, rig.flood(rig.keys.current(OTHER_GROUP)));
}

TEST(ReplayShares, origins_that_were_taken_stay_known_when_a_share_becomes_smaller) {
  Rig rig;
  const int before = rig.flood(rig.group);
  rig.keys.set(OTHER_GROUP, Bytes(16, 9).data());
  for (uint32_t origin = 1000; origin < 1000u + before; origin++) {
    EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(rig.group, Address(origin), nonce(1, origin)));
    EXPECT_TRUE(rig.take(rig.group, Address(origin), nonce(2, 0)));
  }
  for (uint8_t pair = 0; pair < 4; pair++) EXPECT_TRUE(rig.take(pair, Address(pair), nonce(9, 0)));
}

TEST(ReplayShares, a_key_of_one_more_pair_has_a_place_or_is_to_be_refused) {
  Rig rig;
  EXPECT_TRUE(rig.memory->hasPlaceForPair());
  rig.flood(rig.group);
  EXPECT_FALSE(rig.memory->hasPlaceForPair());
  rig.memory->forget(rig.group);
  EXPECT_TRUE(rig.memory->hasPlaceForPair());
}
