#include <gtest/gtest.h>
#include <storage/EepromLayout.h>

#include "support/Addresses.h"
#include "support/ReplayRig.h"

using javinolib::ReplayMemory;

// Power fails in each write that raises a floor, then in one of the boot after it, with weak cells: the floor that the
// first whole boot finds is the old one or the new, and is never lowered by what the weak cells read later.
TEST(WeakFloors, are_the_old_or_the_new_and_are_never_lowered) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    for (uint32_t seed = 1; seed < 60; seed++) {
      ReplayRig rig;
      rig.take(0, SUPP, nonce(9, 9));
      rig.take(0, SUPO, nonce(5, 7));
      rig.eeprom.cutPowerWeaklyAfter(cut, seed);
      try {
        rig.reserve(0, SUPO, nonce(6, 0));
      } catch (const PowerCut &) {
        cuts++;
      }
      rig.eeprom.cutPowerWeaklyAfter(static_cast<int>(seed % 30), seed);
      try {
        rig.powerCycle();
      } catch (const PowerCut &) {
      }
      rig.eeprom.restorePower();
      Bytes floor;
      for (int boots = 0; boots < 8; boots++) {
        rig.powerCycle();
        const Bytes now = rig.floor(0, SUPO);
        ASSERT_TRUE(now == nonce(5, 38) || now == nonce(6, 31)) << cut << " " << seed << " " << toHex(now);
        ASSERT_GE(now, floor) << "cut " << cut << " seed " << seed << " boot " << boots;
        ASSERT_EQ(nonce(9, 40), rig.floor(0, SUPP)) << cut << " " << seed;
        floor = now;
      }
    }
  }
}

TEST(WeakFloors, with_any_one_cell_that_reads_as_it_likes_stay_in_force) {
  for (uint16_t at = javinolib::FLOORS_AT; at < javinolib::FLOORS_AT + 80; at++) {
    ReplayRig rig;
    rig.take(0, SUPP, nonce(9, 9));
    rig.take(0, SUPO, nonce(5, 7));
    rig.eeprom.weaken(at, static_cast<uint8_t>(~rig.eeprom.read(at)));
    for (int boots = 0; boots < 10; boots++) {
      rig.powerCycle();
      ASSERT_EQ(nonce(9, 40), rig.floor(0, SUPP)) << at;
      ASSERT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 7))) << at;
      ASSERT_TRUE(rig.take(0, SUPO, nonce(6, static_cast<uint32_t>(100 * boots))));
      ASSERT_EQ(nonce(6, static_cast<uint32_t>(100 * boots + 31)), rig.floor(0, SUPO)) << at;
    }
  }
}

TEST(WeakFloors, over_random_traffic_and_losses_of_power_never_let_a_nonce_come_twice) {
  for (uint32_t seed = 1; seed <= 20; seed++) {
    RandomBytes random(seed);
    ReplayRig rig;
    Bytes highest[2];
    uint32_t counter = 0;
    for (int i = 0; i < 1500; i++) {
      counter += 1 + random.number(40);
      if (random.number(6) == 0)
        rig.eeprom.cutPowerWeaklyAfter(static_cast<int>(random.number(60)), random.number(1000000));
      const uint8_t key = static_cast<uint8_t>(random.number(2));
      try {
        if (rig.take(key, SUPO, nonce(5, counter))) highest[key] = nonce(5, counter);
        if (random.number(10) == 0) rig.powerCycle();
      } catch (const PowerCut &) {
        rig.eeprom.restorePower();
        rig.powerCycle();
      }
      rig.eeprom.restorePower();
      for (uint8_t any = 0; any < 2; any++) {
        if (highest[any].empty()) continue;
        ASSERT_NE(ReplayMemory::NEWER, rig.judge(any, SUPO, highest[any])) << seed << " " << i;
      }
    }
  }
}
