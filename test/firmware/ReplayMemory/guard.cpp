#include <gtest/gtest.h>
#include <secure/NonceSource.h>
#include <storage/EepromLayout.h>

#include "support/Addresses.h"
#include "support/ReplayRig.h"

using javinolib::Address;
using javinolib::ReplayMemory;
using javinolib::Status;

namespace {

// A memory that something has written over while the board runs.
class ReplayMemoryGuard : public testing::Test {
 protected:
  ReplayMemoryGuard() : nonces(epoch) {
    epoch.begin(false);
    rig.take(0, SUPO, nonce(5, 7));
    rig.take(1, SUPP, nonce(6, 0));
  }

  void change(size_t at) {
    Bytes image = rig.ram.content();
    image[at] = static_cast<uint8_t>(image[at] ^ 0x10);
    rig.ram.restore(image);
  }

  void expectLost() const {
    EXPECT_EQ(ReplayMemory::DAMAGED, rig.judge(0, SUPO, nonce(5, 7)));
    EXPECT_EQ(ReplayMemory::DAMAGED, rig.judge(0, SUPO, nonce(5, 8)));
    EXPECT_EQ(ReplayMemory::DAMAGED, rig.judge(2, ROMA, nonce(9, 9)));
    EXPECT_EQ(Status::MEMORY_DAMAGED, nonces.status()) << "the counter may be one that was given";
  }

  ReplayRig rig;
  javinolib::BootEpoch epoch;
  javinolib::NonceSource nonces;
};

}  // namespace

TEST_F(ReplayMemoryGuard, holds_after_each_change_of_its_own) {
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(0, SUPO, nonce(5, 7)));
  EXPECT_EQ(Status::OK, nonces.status());
  Bytes given(6);
  nonces.take(given.data());
  nonces.raiseEpoch(rig.epoch + 5);
  rig.memory->forget(1);
  EXPECT_EQ(Status::OK, nonces.status());
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(0, SUPO, nonce(5, 7)));
}

TEST_F(ReplayMemoryGuard, refuses_everything_where_any_byte_has_changed) {
  const Bytes image = rig.ram.content();
  for (size_t at = 0; at < offsetof(javinolib::TakenNonces, canary) + 2; at++) {
    rig.ram.restore(image);
    change(at);
    expectLost();
    if (testing::Test::HasFailure()) FAIL() << at;
  }
}

TEST_F(ReplayMemoryGuard, is_not_made_good_by_what_is_done_later) {
  const Bytes image = rig.ram.content();
  for (size_t at : {size_t(4), offsetof(javinolib::TakenNonces, entries) + 9, offsetof(javinolib::TakenNonces, check),
                    offsetof(javinolib::TakenNonces, canary)}) {
    rig.ram.restore(image);
    change(at);
    EXPECT_FALSE(rig.reserve(2, ROMA, nonce(9, 9)));
    rig.memory->remember(0, SUPO, nonce(5, 9).data());
    rig.memory->forget(1);
    rig.keys.erase(1);
    rig.memory->forgetLostKeys();
    nonces.raiseEpoch(1000);
    expectLost();
    if (testing::Test::HasFailure()) FAIL() << at;
  }
}

TEST_F(ReplayMemoryGuard, deletes_no_floor_by_what_it_no_longer_knows) {
  change(offsetof(javinolib::TakenNonces, entries) + offsetof(javinolib::TakenNonce, floor));
  EXPECT_TRUE(rig.memory->forget(0));
  rig.reset();
  EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 38)));
  EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(1, SUPP, nonce(6, 31)));
}

TEST_F(ReplayMemoryGuard, goes_by_the_floors_after_the_next_boot) {
  change(20);
  rig.reset();
  EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, SUPO, nonce(5, 7)));
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, SUPO, nonce(5, 39)));
}

TEST_F(ReplayMemoryGuard, tells_in_the_next_boot_that_the_stack_was_over_it) {
  change(offsetof(javinolib::TakenNonces, canary));
  EXPECT_FALSE(rig.memory->begin(rig.epoch + 1));
  EXPECT_TRUE(rig.memory->begin(rig.epoch + 2));
  change(20);
  EXPECT_TRUE(rig.memory->begin(rig.epoch + 3)) << "a loss of power may have done that";
  rig.ram.losePower();
  EXPECT_TRUE(rig.memory->begin(rig.epoch + 4));
}

TEST_F(ReplayMemoryGuard, while_the_stack_is_over_it_refuses_everything_and_writes_nothing_there) {
  rig.ram.isClear = false;
  const Bytes image = rig.ram.content();
  expectLost();
  EXPECT_FALSE(rig.memory->begin(rig.epoch + 1));
  EXPECT_FALSE(rig.reserve(0, SUPO, nonce(7, 7)));
  rig.memory->remember(0, SUPO, nonce(7, 7).data());
  rig.memory->forget(0);
  nonces.raiseEpoch(1000);
  expectLost();
  EXPECT_EQ(image, rig.ram.content());
}

// ---- Floors that may be lost.

TEST(DoubtfulFloors, refuse_what_no_floor_covers_and_take_what_is_above_one) {
  ReplayRig rig;
  rig.keys.set(Address(0xFFF494), Bytes(16, 77).data());
  const uint8_t group = rig.keys.current(Address(0xFFF494));
  rig.take(group, SUPO, nonce(5, 7));
  rig.take(0, Address(0), nonce(5, 7));
  rig.powerCycle();
  rig.memory->doubtFloors();
  for (int boots = 0; boots < 3; boots++) {
    EXPECT_FALSE(rig.memory->isDoubtful(0)) << "its one origin has a floor";
    EXPECT_EQ(ReplayMemory::BELOW_FLOOR, rig.judge(0, Address(0), nonce(5, 38)));
    EXPECT_EQ(ReplayMemory::NEWER, rig.judge(0, Address(0), nonce(5, 39)));
    EXPECT_TRUE(rig.memory->isDoubtful(1));
    EXPECT_FALSE(rig.take(1, Address(1), nonce(0xFFFFFE, 0xFFFFFF)));
    EXPECT_TRUE(rig.memory->isDoubtful(group));
    EXPECT_EQ(ReplayMemory::REPLAYED, rig.judge(group, SUPP, nonce(0xFFFFFE, 0)));
    EXPECT_EQ(ReplayMemory::NEWER, rig.judge(group, SUPO, nonce(5, 39)));
    rig.powerCycle();
    if (boots == 1) rig.memory->doubtFloors();
  }
}

TEST(DoubtfulFloors, go_with_their_key) {
  ReplayRig rig;
  rig.memory->doubtFloors();
  rig.keys.erase(1);
  rig.memory->forget(1);
  rig.keys.set(Address(1), Bytes(16, 9).data());
  EXPECT_FALSE(rig.memory->isDoubtful(1));
  EXPECT_TRUE(rig.take(1, Address(1), nonce(1, 1)));
  EXPECT_TRUE(rig.memory->isDoubtful(2));
}
