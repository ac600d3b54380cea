#include <gtest/gtest.h>

#include <cstring>

#include "radio/RadioQueue.h"

using javinolib::RadioPacket;
using javinolib::RadioQueue;

namespace {

void put(RadioQueue &queue, const char *text) {
  RadioPacket *packet = queue.claim();
  ASSERT_NE(packet, nullptr);
  packet->room[0] = static_cast<uint8_t>(std::strlen(text) + 3);
  std::memcpy(packet->room + 1, text, std::strlen(text));
  queue.commit();
}

std::string take(RadioQueue &queue) {
  const RadioPacket *packet = queue.oldest();
  if (!packet) return "";
  const std::string text(reinterpret_cast<const char *>(packet->payload()), packet->payloadLength());
  queue.release();
  return text;
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

TEST(RadioQueue, hasNoSlotLeftWhenTwoWait) {
  RadioQueue queue;
  put(queue, "a");
  put(queue, "b");
  EXPECT_EQ(queue.claim(), nullptr);
  EXPECT_EQ(take(queue), "a");
  put(queue, "c");
  EXPECT_EQ(queue.claim(), nullptr);
  EXPECT_EQ(take(queue), "b");
}

TEST(RadioQueue, keepsAClaimedSlotThroughReading) {
  RadioQueue queue;
  put(queue, "old");
  RadioPacket *packet = queue.claim();
  EXPECT_EQ(queue.claim(), packet);
  EXPECT_EQ(take(queue), "old");
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.claim(), packet);
}

TEST(RadioQueue, carriesTheLongestPayload) {
  RadioQueue queue;
  const std::string longest(77, 'x');
  put(queue, longest.c_str());
  EXPECT_EQ(take(queue), longest);
}
