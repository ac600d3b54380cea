#include <gtest/gtest.h>

#include "support/Modem.h"

TEST(AskRadio, isDeafWhileSending) {
  Modem modem;
  modem.send(Bytes(77, 1));
  modem.hardware.play(packetLine({1, 2, 3}));
  EXPECT_TRUE(modem.radio.sending());
  EXPECT_EQ(modem.take(), Bytes());
  EXPECT_EQ(modem.counters().damaged, 0u);
}

TEST(AskRadio, hearsAgainAfterSending) {
  Modem modem;
  modem.send({1, 2, 3});
  modem.hardware.wait(200 * Modem::BIT);
  modem.hardware.play(packetLine({4, 5}));
  EXPECT_EQ(modem.take(), (Bytes{4, 5}));
}

TEST(AskRadio, countsAsMissedThePacketThatItsOwnSendingCuts) {
  Modem modem;
  const Bits bits = reference::packetBits({1, 2, 3, 4});
  modem.hardware.play(AirLine().bits(Bits(bits.begin(), bits.begin() + 80), Modem::BIT));
  modem.send({9});
  modem.hardware.play(AirLine().bits(Bits(bits.begin() + 80, bits.end()), Modem::BIT).silence(200 * Modem::BIT));
  EXPECT_EQ(modem.counters().missed, 1u);
  EXPECT_EQ(modem.counters().received, 0u);
  EXPECT_EQ(modem.counters().sent, 1u);
}

TEST(AskRadio, refusesToSendWhileAllBuffersHoldWhatItReceived) {
  Modem modem;
  for (uint8_t i = 0; i < javinolib::RadioQueue::CAPACITY; i++) modem.hardware.play(packetLine({1, i}));
  EXPECT_FALSE(modem.send({9}));
  EXPECT_FALSE(modem.radio.sending());
  EXPECT_EQ(modem.take(), (Bytes{1, 0}));
  EXPECT_TRUE(modem.send({9}));
  modem.hardware.wait(200 * Modem::BIT);
  for (uint8_t i = 1; i < javinolib::RadioQueue::CAPACITY; i++) EXPECT_EQ(modem.take(), (Bytes{1, i}));
  modem.hardware.play(packetLine({4, 5}));
  EXPECT_EQ(modem.take(), (Bytes{4, 5}));
}

TEST(AskRadio, keepsWhatItReceivedBeforeSending) {
  Modem modem;
  modem.hardware.play(packetLine({1, 2}));
  modem.send({9});
  modem.hardware.wait(200 * Modem::BIT);
  EXPECT_EQ(modem.take(), (Bytes{1, 2}));
}
