#include <gtest/gtest.h>
#include <secure/NonceSource.h>

#include "support/ReplayRig.h"
#include "support/SimulatedEeprom.h"

using javinolib::BootEpoch;
using javinolib::NonceSource;

namespace {

// A source in epoch 1 that has given the counters 0…99.
class NonceRaisingTest : public testing::Test {
 protected:
  NonceRaisingTest() : nonces(epoch) {
    epoch.begin(false);
    javinolib::retained::beginEpoch(epoch.value());
    for (int i = 0; i < 100; i++) next();
  }

  Bytes next() {
    Bytes nonce(6);
    nonces.take(nonce.data());
    return nonce;
  }

  bool raise(const Bytes &floor, const Bytes &of) { return nonces.raiseAbove(floor.data(), of.data()); }

  SimulatedEeprom eeprom;
  SimulatedRam ram;
  BootEpoch epoch;
  NonceSource nonces;
};

}  // namespace

TEST_F(NonceRaisingTest, goes_on_right_above_the_floor) {
  EXPECT_TRUE(raise(nonce(1, 130), nonce(1, 99)));
  EXPECT_EQ(nonce(1, 131), next());
}

TEST_F(NonceRaisingTest, takes_floors_up_to_31_above_the_nonce_of_the_frame) {
  EXPECT_FALSE(raise(nonce(1, 131), nonce(1, 99)));
  EXPECT_EQ(nonce(1, 100), next());
  EXPECT_TRUE(raise(nonce(1, 131), nonce(1, 100)));
  EXPECT_EQ(nonce(1, 132), next());
}

TEST_F(NonceRaisingTest, rises_by_31_for_each_frame_however_often_it_is_asked) {
  for (uint32_t floor = 100; floor < 100000; floor++) raise(nonce(1, floor), nonce(1, 99));
  EXPECT_EQ(nonce(1, 131), next());
}

TEST_F(NonceRaisingTest, never_goes_back) {
  for (uint32_t floor : {0, 50, 99}) {
    EXPECT_TRUE(raise(nonce(1, floor), nonce(1, 99))) << floor;
    EXPECT_GT(next(), nonce(1, 99)) << floor;
  }
}

TEST_F(NonceRaisingTest, ignores_floors_of_other_epochs) {
  for (uint32_t other : {0u, 2u, 0x010001u, 0xFFFFFFu}) {
    EXPECT_FALSE(raise(nonce(other, 101), nonce(1, 99))) << other;
  }
  EXPECT_EQ(nonce(1, 100), next());
}

TEST_F(NonceRaisingTest, to_the_very_last_nonce_exhausts_it) {
  for (uint32_t floor = 130; floor < 0xFFFFFF; floor += 31) ASSERT_TRUE(raise(nonce(1, floor), nonce(1, floor - 31)));
  EXPECT_TRUE(raise(nonce(1, 0xFFFFFF), nonce(1, 0xFFFFF0)));
  EXPECT_EQ(javinolib::Status::NONCE_EXHAUSTED, nonces.status());
}

TEST_F(NonceRaisingTest, begins_a_higher_epoch_at_its_first_nonce) {
  nonces.raiseEpoch(7);
  EXPECT_EQ(nonce(7, 0), next());
  EXPECT_EQ(nonce(7, 1), next());
}

TEST_F(NonceRaisingTest, goes_on_in_its_epoch_where_that_is_not_lower) {
  for (uint32_t epoch : {0, 1}) nonces.raiseEpoch(epoch);
  EXPECT_EQ(nonce(1, 100), next());
}

TEST_F(NonceRaisingTest, of_an_epoch_begins_the_next_boot_above_it) {
  nonces.raiseEpoch(0x070000);
  epoch = BootEpoch();
  epoch.begin(false);
  EXPECT_EQ(0x070001u, epoch.value());
}
