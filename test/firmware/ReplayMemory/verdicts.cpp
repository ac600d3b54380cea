#include <gtest/gtest.h>

#include "support/Addresses.h"
#include "support/ReplayRig.h"

using javinolib::Address;
using javinolib::ReplayMemory;

TEST(ReplayMemory, takes_only_higher_nonces) {
  ReplayRig rig;
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(0, 0))) << "the first one, whatever it is";
  rig.take(0, SUPO, nonce(5, 7));
  const struct {
    uint32_t epoch;
    uint32_t counter;
    ReplayMemory::Verdict verdict;
  } cases[] = {{5, 7, ReplayMemory::REPEATED},        {5, 6, ReplayMemory::REPLAYED},
               {4, 0xFFFFFF, ReplayMemory::REPLAYED}, {5, 8, ReplayMemory::NEWER},
               {6, 0, ReplayMemory::NEWER},           {0x010000, 0, ReplayMemory::NEWER},
               {0, 0x800000, ReplayMemory::REPLAYED}, {5, 0x100, ReplayMemory::NEWER}};
  for (const auto &entry : cases) {
    EXPECT_EQ(entry.verdict, rig.judge(0, SUPO, nonce(entry.epoch, entry.counter)))
        << entry.epoch << "/" << entry.counter;
  }
}

TEST(ReplayMemory, a_nonce_that_is_reserved_only_is_not_taken) {
  ReplayRig rig;
  EXPECT_TRUE(rig.reserve(0, SUPO, nonce(5, 7)));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(5, 7)));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(0, 0)));
}

TEST(ReplayMemory, the_highest_nonce_stays_whatever_is_remembered_later) {
  ReplayRig rig;
  for (uint32_t counter : {9, 12, 10}) {
    ASSERT_TRUE(rig.reserve(0, SUPO, nonce(5, counter)));
  }
  for (uint32_t counter : {9, 12, 10}) rig.memory->remember(0, SUPO, nonce(5, counter).data());
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(0, SUPO, nonce(5, 12)));
  EXPECT_EQ(ReplayMemory::REPLAYED, rig.judge(0, SUPO, nonce(5, 10)));
}

TEST(ReplayMemory, keeps_origins_and_keys_apart) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(1, SUPO, nonce(1, 1)));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPP, nonce(1, 1)));
}

TEST(ReplayMemory, refuses_new_origins_when_full_and_forgets_none) {
  ReplayRig rig;
  for (uint8_t i = 0; i < javinolib::config::REPLAY_ENTRIES; i++) EXPECT_TRUE(rig.take(0, Address(i), nonce(5, i)));
  for (int boots = 0; boots < 2; boots++) {
    EXPECT_EQ(ReplayMemory::FULL, rig.judge(0, SUPO, nonce(9, 9)));
    EXPECT_FALSE(rig.reserve(0, SUPO, nonce(9, 9)));
    for (uint8_t i = 0; i < javinolib::config::REPLAY_ENTRIES; i++) {
      EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(0, Address(i), nonce(5, i)));
      EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, Address(i), nonce(6, i)));
    }
    rig.reset();
  }
}

TEST(ReplayMemory, forgets_what_came_under_one_key_only_and_for_good) {
  ReplayRig rig;
  rig.take(0, SUPO, nonce(5, 7));
  rig.take(1, SUPO, nonce(5, 7));
  EXPECT_TRUE(rig.memory->forget(0));
  for (int boots = 0; boots < 2; boots++) {
    EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(0, 0)));
    EXPECT_NE(ReplayMemory::NEWER, rig.judge(1, SUPO, nonce(5, 7)));
    rig.powerCycle();
  }
}

TEST(ReplayMemory, remembers_nothing_of_a_key_that_was_forgotten_while_the_message_waited) {
  ReplayRig rig;
  rig.reserve(0, SUPO, nonce(5, 7));
  rig.memory->forget(0);
  rig.memory->remember(0, SUPO, nonce(5, 7).data());
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(5, 7)));
  EXPECT_EQ(Bytes(6), rig.floor(0, SUPO));
}
