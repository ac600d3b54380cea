#include <gtest/gtest.h>

#include <cstring>

#include "radio/RadioQueue.h"

using javino::RadioQueue;

namespace {

void put(RadioQueue &queue, const char *text) {
  uint8_t *slot = queue.claim();
  ASSERT_NE(slot, nullptr);
  std::memcpy(slot, text, std::strlen(text));
  queue.commit(static_cast<uint8_t>(std::strlen(text)));
}

std::string take(RadioQueue &queue) {
  uint8_t payload[77];
  const uint8_t length = queue.take(payload);
  return std::string(reinterpret_cast<char *>(payload), length);
}

}  // namespace

TEST(RadioQueue, givesPacketsInTheirOrder) {
  RadioQueue queue;
  for (int round = 0; round < 300; round++) {
    put(queue, "first");
    put(queue, "second");
    EXPECT_EQ(take(queue), "first");
    put(queue, "third");
    EXPECT_EQ(take(queue), "second");
    EXPECT_EQ(take(queue), "third");
    EXPECT_EQ(take(queue), "");
  }
}

TEST(RadioQueue, hasNoSlotLeftWhenThreeWait) {
  RadioQueue queue;
  put(queue, "a");
  put(queue, "b");
  put(queue, "c");
  EXPECT_EQ(queue.claim(), nullptr);
  EXPECT_EQ(take(queue), "a");
  put(queue, "d");
  EXPECT_EQ(queue.claim(), nullptr);
  EXPECT_EQ(take(queue), "b");
}

TEST(RadioQueue, keepsAClaimedSlotThroughReadingAndClearing) {
  RadioQueue queue;
  put(queue, "old");
  uint8_t *slot = queue.claim();
  EXPECT_EQ(queue.claim(), slot);
  queue.clear();
  EXPECT_TRUE(queue.empty());
  std::memcpy(slot, "new", 3);
  queue.commit(3);
  EXPECT_EQ(take(queue), "new");
}

TEST(RadioQueue, carriesTheLongestPayload) {
  RadioQueue queue;
  const std::string longest(77, 'x');
  put(queue, longest.c_str());
  EXPECT_EQ(take(queue), longest);
}
