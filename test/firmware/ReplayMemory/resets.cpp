#include <gtest/gtest.h>

#include <cstring>

#include "support/Addresses.h"
#include "support/ReplayRig.h"

using javinolib::Address;
using javinolib::ReplayMemory;

TEST(ReplayMemoryReset, keeps_what_was_taken_exactly) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  rig.take(1, SUPP, nonce(6, 0));
  for (int resets = 0; resets < 3; resets++) {
    rig.reset();
    EXPECT_EQ(ReplayMemory::REPLAYED, rig.judge(0, SUPO, nonce(5, 6)));
    EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(0, SUPO, nonce(5, 7)));
    EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(5, 8)));
    EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(1, SUPP, nonce(6, 0)));
  }
}

TEST(ReplayMemoryReset, accepts_again_what_was_reserved_and_not_taken) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  rig.reserve(0, SUPO, nonce(5, 200));
  rig.reserve(0, SUPP, nonce(6, 0));
  rig.reset();
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(0, SUPO, nonce(5, 7)));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(5, 200)));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPP, nonce(6, 0)));
}

TEST(ReplayMemoryReset, after_a_loss_of_power_keeps_the_floor_as_it_was_then) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  rig.powerCycle();
  rig.reserve(0, SUPO, nonce(5, 39));
  rig.reset();
  EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 38)));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(5, 39)));
}

TEST(ReplayMemoryReset, with_any_changed_bit_in_RAM_trusts_the_floor_only) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  rig.take(1, SUPP, nonce(6, 0));
  const Bytes image = rig.ram.content();
  const size_t used = offsetof(javinolib::TakenNonces, check) + 2;
  for (size_t bit = 0; bit < used * 8; bit++) {
    Bytes damaged = image;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ 1 << bit % 8);
    rig.ram.restore(damaged);
    rig.epoch = 1;
    rig.reset();
    ASSERT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 38))) << bit;
    ASSERT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(1, SUPP, nonce(6, 31))) << bit;
    ASSERT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(5, 39))) << bit;
  }
}

TEST(ReplayMemoryReset, does_not_trust_an_old_image_that_came_back) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  const Bytes image = rig.ram.content();
  rig.take(0, SUPO, nonce(5, 9));
  rig.reset();
  rig.ram.restore(image);
  rig.reset();
  EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 8)));
}

TEST(ReplayMemoryReset, with_random_RAM_never_accepts_what_was_accepted) {
  ReplayRig rig;
  for (uint32_t i = 0; i < 2000; i++) {
    ASSERT_TRUE(rig.take(0, SUPO, nonce(5, 40 * i)));
    rig.powerCycle();
    ASSERT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 40 * i)));
  }
}

TEST(ReplayMemoryReset, between_key_and_floors_leaves_nothing_of_a_deleted_key) {
  ReplayRig rig;
  rig.take(3, SUPO, nonce(5, 7));
  rig.keys.erase(3);
  rig.reset();
  rig.keys.set(Address(3), Bytes(16, 9).data());
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(3, SUPO, nonce(0, 0)));
}
