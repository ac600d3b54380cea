#include <gtest/gtest.h>

#include <map>

#include "support/Addresses.h"
#include "support/ReplayRig.h"

using javinolib::Address;
using javinolib::ReplayMemory;

TEST(ReplayMemoryPowerCuts, at_any_write_leave_the_old_floor_or_the_new) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    for (int garbage = 0; garbage < 256; garbage += 15) {
      ReplayRig rig;
      rig.take(0, SUPP, nonce(9, 9));
      rig.take(0, SUPO, nonce(5, 7));
      rig.eeprom.cutPowerAfter(cut, static_cast<uint8_t>(garbage));
      try {
        rig.reserve(0, SUPO, nonce(6, 0));
      } catch (const PowerCut &) {
        cuts++;
      }
      rig.eeprom.restorePower();
      rig.powerCycle();
      const Bytes floor = rig.floor(0, SUPO);
      ASSERT_TRUE(floor == nonce(5, 38) || floor == nonce(6, 31)) << cut << " " << garbage << " " << toHex(floor);
      ASSERT_EQ(nonce(9, 40), rig.floor(0, SUPP)) << cut << " " << garbage;
    }
  }
}

TEST(ReplayMemoryPowerCuts, while_forgetting_a_key_leave_the_others) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    ReplayRig rig;
    rig.take(0, SUPO, nonce(5, 7));
    rig.take(0, SUPP, nonce(5, 7));
    rig.take(1, SUPO, nonce(5, 7));
    rig.eeprom.cutPowerAfter(cut, 0x5A);
    try {
      rig.memory->forget(0);
    } catch (const PowerCut &) {
      cuts++;
    }
    rig.eeprom.restorePower();
    rig.powerCycle();
    ASSERT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(1, SUPO, nonce(5, 7))) << cut;
    ASSERT_TRUE(rig.memory->forget(0));
    ASSERT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(0, 0))) << cut;
    ASSERT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPP, nonce(0, 0))) << cut;
  }
}

// The property itself: whatever happens, nothing that the host has taken is ever accepted again.
TEST(ReplayMemoryPowerCuts, resets_and_random_traffic_never_take_a_nonce_twice) {
  RandomBytes random(21);
  ReplayRig rig;
  typedef std::pair<uint8_t, uint32_t> Stream;  // key and origin
  std::map<Stream, std::map<Bytes, bool>> taken;
  std::map<uint32_t, uint32_t> epochs;
  std::map<uint32_t, uint32_t> counters;
  for (int i = 0; i < 20000; i++) {
    const uint32_t origin = random.number(5);
    const uint8_t key = random.number(2);
    if (random.number(400) == 0) epochs[origin]++, counters[origin] = 0;
    counters[origin] += random.number(3);
    const bool replay = random.number(3) == 0;
    const uint32_t counter = replay ? random.number(counters[origin] + 1) : counters[origin];
    const Bytes now = nonce(epochs[origin] - (replay && epochs[origin] > 0 ? random.number(2) : 0), counter);
    if (random.number(50) == 0) rig.eeprom.cutPowerAfter(static_cast<int>(random.number(16)), random.byte());
    try {
      if (rig.take(key, Address(origin), now)) {
        ASSERT_FALSE(taken[Stream(key, origin)][now]) << i << ": " << toHex(now) << " came twice";
        taken[Stream(key, origin)][now] = true;
      }
      if (random.number(200) == 0) rig.reset();
    } catch (const PowerCut &) {
      rig.eeprom.restorePower();
      rig.powerCycle();
    }
    rig.eeprom.restorePower();
    if (random.number(300) == 0) rig.powerCycle();
  }
  EXPECT_GT(taken.size(), 9u);
}
