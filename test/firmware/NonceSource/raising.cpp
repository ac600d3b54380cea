#include <gtest/gtest.h>
#include <secure/NonceSource.h>

#include "support/ReplayRig.h"
#include "support/SimulatedEeprom.h"

using javino::BootEpoch;
using javino::NonceSource;

namespace {

// A source in epoch 1 that has given the counters 0…99.
class NonceRaisingTest : public testing::Test {
 protected:
  NonceRaisingTest() : nonces(epoch) {
    epoch.begin();
    for (int i = 0; i < 100; i++) next();
  }

  Bytes next() {
    Bytes nonce(6);
    nonces.take(nonce.data());
    return nonce;
  }

  SimulatedEeprom eeprom;
  BootEpoch epoch;
  NonceSource nonces;
};

}  // namespace

TEST_F(NonceRaisingTest, goes_on_right_above_the_floor) {
  EXPECT_TRUE(nonces.raiseAbove(nonce(1, 131).data()));
  EXPECT_EQ(nonce(1, 132), next());
}

TEST_F(NonceRaisingTest, takes_floors_up_to_32_above_the_next_nonce) {
  EXPECT_FALSE(nonces.raiseAbove(nonce(1, 133).data()));
  EXPECT_EQ(nonce(1, 100), next());
  EXPECT_TRUE(nonces.raiseAbove(nonce(1, 133).data()));
  EXPECT_EQ(nonce(1, 134), next());
}

TEST_F(NonceRaisingTest, never_goes_back) {
  for (uint32_t floor : {0, 50, 99}) {
    EXPECT_TRUE(nonces.raiseAbove(nonce(1, floor).data())) << floor;
    EXPECT_GT(next(), nonce(1, 99)) << floor;
  }
}

TEST_F(NonceRaisingTest, ignores_floors_of_other_epochs) {
  for (uint32_t other : {0u, 2u, 0x010001u, 0xFFFFFFu}) {
    EXPECT_FALSE(nonces.raiseAbove(nonce(other, 101).data())) << other;
  }
  EXPECT_EQ(nonce(1, 100), next());
}

TEST_F(NonceRaisingTest, to_the_very_last_nonce_exhausts_it) {
  for (uint32_t floor = 131; floor < 0xFFFFFF; floor += 32) ASSERT_TRUE(nonces.raiseAbove(nonce(1, floor).data()));
  EXPECT_TRUE(nonces.raiseAbove(nonce(1, 0xFFFFFF).data()));
  EXPECT_TRUE(nonces.isExhausted());
}
