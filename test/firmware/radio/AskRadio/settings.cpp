#include <gtest/gtest.h>

#include "support/Modem.h"

using javinolib::AskRadio;

TEST(AskRadio, beginsAtRatesFrom200To10000) {
  SimulatedAsk hardware;
  for (uint16_t rate : {200, 1000, 2000, 10000}) EXPECT_TRUE(AskRadio(11, 12, rate).begin()) << rate;
  for (uint16_t rate : {0, 1, 199, 10001, 65535}) EXPECT_FALSE(AskRadio(11, 12, rate).begin()) << rate;
}

TEST(AskRadio, doesNotBeginOnAPinWithoutEdges) {
  SimulatedAsk hardware;
  EXPECT_FALSE(AskRadio(SimulatedAsk::PIN_WITHOUT_EDGES, 12).begin());
}

TEST(AskRadio, doesNothingWhereItCouldNotBegin) {
  SimulatedAsk hardware;
  AskRadio radio(11, 12, 0);
  EXPECT_FALSE(radio.begin());
  const uint8_t payload[] = {1};
  EXPECT_FALSE(radio.send(payload, 1));
  hardware.play(packetLine({1}));
  EXPECT_EQ(hardware.interrupts(), 0u);
  EXPECT_TRUE(radio.idle());
}

TEST(AskRadio, hearsNothingBeforeItBegins) {
  SimulatedAsk hardware;
  AskRadio radio;
  hardware.play(packetLine({1}));
  EXPECT_EQ(hardware.interrupts(), 0u);
  ASSERT_TRUE(radio.begin());
  hardware.play(packetLine({2}));
  javinolib::Received with = {0, 0};
  const uint8_t *payload = radio.receive(with);
  ASSERT_EQ(with.length, 1);
  EXPECT_EQ(payload[0], 2);
}

// 84 bits and 12 more for each byte; a slot is 16 bits, rounded up.
TEST(AskRadio, tellsAirtimeAndSlotOfItsBitRate) {
  EXPECT_EQ(AskRadio().airtimeMillis(1), 48);
  EXPECT_EQ(AskRadio().airtimeMillis(77), 504);
  EXPECT_EQ(AskRadio().slotMillis(), 8);
  EXPECT_EQ(AskRadio(11, 12, 4800).airtimeMillis(77), 210);
  EXPECT_EQ(AskRadio(11, 12, 4800).slotMillis(), 4);
  EXPECT_EQ(AskRadio(11, 12, 200).airtimeMillis(77), 5040);
  EXPECT_EQ(AskRadio(11, 12, 200).slotMillis(), 80);
}

TEST(AskRadio, carriesTheLongestPayload) { EXPECT_EQ(AskRadio().longestPayload(), javinolib::MAX_RADIO_PAYLOAD); }

TEST(AskRadio, sendsAndReceivesAtEachRate) {
  for (uint16_t rate : {200, 300, 1200, 2000, 4800, 9600}) {
    const double bitTicks = double(SimulatedAsk::TICKS_PER_SECOND) / rate;
    SimulatedAsk hardware;
    AskRadio radio(11, 12, rate);
    ASSERT_TRUE(radio.begin());
    hardware.play(packetLine({1, 2, 3}, bitTicks));
    javinolib::Received with = {0, 0};
    ASSERT_NE(radio.receive(with), nullptr) << rate << " bit/s";
    EXPECT_EQ(with.length, 3) << rate << " bit/s";
    radio.release();

    const uint8_t payload[] = {1, 2, 3};
    ASSERT_TRUE(radio.send(payload, sizeof payload));
    hardware.wait(static_cast<uint64_t>(122 * bitTicks));
    EXPECT_FALSE(radio.sending()) << rate << " bit/s";
  }
}
