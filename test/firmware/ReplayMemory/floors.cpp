#include <gtest/gtest.h>
#include <storage/EepromLayout.h>

#include "support/Addresses.h"
#include "support/ReplayRig.h"

using javinolib::Address;
using javinolib::ReplayMemory;

namespace {

int writesOfFloors(const ReplayRig &rig) {
  int writes = 0;
  for (uint16_t at = javinolib::FLOORS_AT; at < javinolib::RELAYING_AT; at++) writes += rig.eeprom.writesOf(at);
  return writes;
}

}  // namespace

TEST(ReplayFloor, is_31_above_the_nonce_that_it_is_written_for) {
  ReplayRig rig;
  EXPECT_EQ(Bytes(6), rig.floor(0, SUPO)) << "none";
  rig.reserve(0, SUPO, nonce(5, 7));
  EXPECT_EQ(nonce(5, 38), rig.floor(0, SUPO));
  rig.reserve(0, SUPO, nonce(5, 39));
  EXPECT_EQ(nonce(5, 70), rig.floor(0, SUPO));
  rig.reserve(0, SUPO, nonce(6, 0));
  EXPECT_EQ(nonce(6, 31), rig.floor(0, SUPO));
}

TEST(ReplayFloor, stays_within_the_epoch) {
  ReplayRig rig;
  rig.reserve(0, SUPO, nonce(5, 0xFFFFF0));
  EXPECT_EQ(nonce(5, 0xFFFFFF), rig.floor(0, SUPO));
  EXPECT_TRUE(rig.take(0, SUPO, nonce(5, 0xFFFFFF)));
  EXPECT_TRUE(rig.take(0, SUPO, nonce(6, 0)));
}

TEST(ReplayFloor, is_written_once_for_32_messages) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 0));
  const int before = writesOfFloors(rig);
  for (uint32_t counter = 1; counter < 32; counter++) EXPECT_TRUE(rig.take(0, SUPO, nonce(5, counter)));
  EXPECT_EQ(before, writesOfFloors(rig));
  EXPECT_TRUE(rig.take(0, SUPO, nonce(5, 32)));
  EXPECT_LT(before, writesOfFloors(rig));
}

TEST(ReplayFloor, makes_all_stale_that_is_not_above_it_when_power_was_lost) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  rig.take(0, SUPO, nonce(5, 9));
  rig.powerCycle();
  for (uint32_t counter : {0, 7, 9, 10, 38})
    EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, counter))) << counter;
  EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(4, 0xFFFFFF)));
  EXPECT_EQ(nonce(5, 38), rig.floor(0, SUPO));
  EXPECT_TRUE(rig.take(0, SUPO, nonce(5, 39)));
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(0, SUPO, nonce(5, 39)));
  EXPECT_EQ(ReplayMemory::REPLAYED, rig.judge(0, SUPO, nonce(5, 38)));
}

TEST(ReplayFloor, that_is_raised_for_what_waits_does_not_make_that_stale) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  rig.powerCycle();
  EXPECT_TRUE(rig.reserve(0, SUPO, nonce(5, 39)));
  EXPECT_EQ(nonce(5, 70), rig.floor(0, SUPO));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(5, 39)));
  EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 38)));
}

TEST(ReplayFloor, of_a_key_that_is_gone_is_erased_at_the_next_boot) {
  ReplayRig rig;
  rig.take(2, SUPO, nonce(5, 7));
  rig.keys.erase(2);
  for (int boots = 0; boots < 2; boots++) {
    rig.reset();
    EXPECT_EQ(ReplayMemory::NEWER, rig.judge(2, SUPO, nonce(0, 0)));
  }
  rig.keys.set(Address(2), Bytes(16, 9).data());
  rig.powerCycle();
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(2, SUPO, nonce(0, 0)));
}

TEST(ReplayFloor, that_cannot_be_written_is_told_and_nothing_is_remembered) {
  ReplayRig rig;
  for (uint16_t at = javinolib::FLOORS_AT; at < javinolib::RELAYING_AT; at++) rig.eeprom.wearOut(at);
  EXPECT_FALSE(rig.reserve(0, SUPO, nonce(5, 7)));
  EXPECT_EQ(Bytes(6), rig.floor(0, SUPO));
}

TEST(ReplayFloor, passes_over_worn_places) {
  ReplayRig rig;
  for (uint16_t place = 0; place < javinolib::config::FLOOR_SLOTS; place++) {
    if (place % 7 != 0)
      rig.eeprom.wearOut(static_cast<uint16_t>(javinolib::FLOORS_AT + place * javinolib::FLOOR_PLACE_LENGTH +
                                               place % javinolib::FLOOR_PLACE_LENGTH));
  }
  for (uint32_t counter = 0; counter < 5000; counter += 32) {
    ASSERT_TRUE(rig.take(0, SUPO, nonce(5, counter)));
    ASSERT_EQ(nonce(5, counter + 31), rig.floor(0, SUPO));
  }
  rig.powerCycle();
  EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 4992)));
}

TEST(ReplayFloor, that_no_longer_can_be_erased_does_not_lower_the_one_in_force) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 0));
  for (uint16_t place = 0; place < javinolib::config::FLOOR_SLOTS; place++) {
    const uint16_t at = static_cast<uint16_t>(javinolib::FLOORS_AT + place * javinolib::FLOOR_PLACE_LENGTH);
    if (rig.eeprom.read(static_cast<uint16_t>(at + javinolib::FLOOR_PLACE_LENGTH - 1)) == 0xFF) continue;
    for (uint16_t i = 0; i < javinolib::FLOOR_PLACE_LENGTH; i++) rig.eeprom.wearOut(static_cast<uint16_t>(at + i));
  }
  EXPECT_TRUE(rig.take(0, SUPO, nonce(5, 100)));
  for (int boots = 0; boots < 3; boots++) {
    rig.powerCycle();
    EXPECT_EQ(nonce(5, 131), rig.floor(0, SUPO));
    EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 131)));
  }
}

TEST(ReplayFloor, wear_is_spread_over_the_free_places) {
  ReplayRig rig;
  for (uint8_t i = 1; i < javinolib::config::REPLAY_ENTRIES; i++) rig.take(1, Address(i), nonce(5, i));
  const int uses = 7200;
  for (int i = 0; i < uses; i++) {
    ASSERT_TRUE(rig.take(0, SUPO, nonce(5, static_cast<uint32_t>(32 * i))));
    if (i % 11 == 0) rig.powerCycle();
  }
  const int free = javinolib::config::FLOOR_SLOTS - javinolib::config::REPLAY_ENTRIES;
  for (uint16_t at = javinolib::FLOORS_AT; at < javinolib::RELAYING_AT; at++) {
    EXPECT_LE(rig.eeprom.writesOf(at), 2 * uses / free * 5 / 4) << at;
  }
}
