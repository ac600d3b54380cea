#include <delivery/BroadcastMemory.h>

#include <gtest/gtest.h>

using javinolib::BroadcastMemory;

namespace {

const uint8_t HELP[] = "////ROMABItell;help";
const uint32_t AIRTIME = 156;

class BroadcastMemoryTest : public ::testing::Test {
 protected:
  bool isRepeat(uint32_t begun) { return isRepeat(begun, begun + AIRTIME); }

  bool isRepeat(uint32_t begun, uint32_t ended) {
    return memory_.isRepeat(HELP, sizeof HELP - 1, ended, static_cast<uint16_t>(ended - begun));
  }

  BroadcastMemory memory_;
};

}  // namespace

TEST_F(BroadcastMemoryTest, the_same_again_within_400_ms_is_a_repeat) {
  EXPECT_FALSE(isRepeat(1000));
  EXPECT_TRUE(isRepeat(1000 + AIRTIME + 400));
}

TEST_F(BroadcastMemoryTest, the_same_again_later_is_none) {
  EXPECT_FALSE(isRepeat(1000));
  EXPECT_FALSE(isRepeat(1000 + AIRTIME + 401));
}

TEST_F(BroadcastMemoryTest, the_same_again_while_the_first_still_came_in_fragments_is_a_repeat) {
  EXPECT_FALSE(isRepeat(1000, 12000));
  EXPECT_TRUE(isRepeat(2000, 12500));
}

// A relay may copy the first behind the second (SPEC 7.5).
TEST_F(BroadcastMemoryTest, the_same_again_behind_others_is_a_repeat) {
  EXPECT_FALSE(isRepeat(1000));
  for (const uint8_t other : {0, 1}) EXPECT_FALSE(memory_.isRepeat(&other, 1, 1200, 156));
  EXPECT_TRUE(isRepeat(1300));
}

TEST_F(BroadcastMemoryTest, the_clock_runs_over_between_the_two) {
  EXPECT_FALSE(isRepeat(0xFFFFFFFF - AIRTIME));
  EXPECT_TRUE(isRepeat(200));
}

TEST_F(BroadcastMemoryTest, the_same_again_after_weeks_of_silence_is_none) {
  const uint32_t day = 24u * 3600 * 1000;
  for (uint32_t days : {1u, 20u, 24u, 25u, 26u, 30u, 40u, 49u}) {
    BroadcastMemory fresh;
    memory_ = fresh;
    EXPECT_FALSE(isRepeat(1000));
    EXPECT_FALSE(isRepeat(1000 + days * day)) << days << " days";
  }
}
