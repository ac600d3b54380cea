#include <gtest/gtest.h>

#include "support/Decoder.h"
#include "support/Vectors.h"

TEST(RadioDecoder, decodesTheVectors) {
  for (const RadioVector &vector : radioVectors()) {
    Decoder decoder;
    decoder.add(vector.bits);
    EXPECT_EQ(decoder.takeIntact(), vector.payload);
    EXPECT_EQ(decoder.counters().damaged, 0u);
  }
}

TEST(RadioDecoder, decodesEachLength) {
  for (size_t length = 1; length <= 77; length++) {
    Bytes payload;
    for (size_t i = 0; i < length; i++) payload.push_back(static_cast<uint8_t>(i * 101 + length));
    Decoder decoder;
    decoder.add(reference::packetBits(payload));
    EXPECT_EQ(decoder.takeIntact(), payload);
  }
}

TEST(RadioDecoder, needsNoTraining) {
  Decoder decoder;
  const Bits bits = reference::packetBits({1, 2, 3});
  decoder.add(Bits(bits.begin() + 36, bits.end()));
  EXPECT_EQ(decoder.takeIntact(), (Bytes{1, 2, 3}));
}

TEST(RadioDecoder, decodesAPacketRightAfterAnother) {
  Decoder decoder;
  for (uint8_t i = 0; i < 100; i++) {
    decoder.add(reference::packetBits({i, 0x2F}));
    EXPECT_EQ(decoder.takeIntact(), (Bytes{i, 0x2F}));
  }
}

TEST(RadioDecoder, countsAsMissedWhatFindsNoSlotAndKeepsTheOldest) {
  Decoder decoder;
  for (uint8_t i = 0; i < 5; i++) decoder.add(reference::packetBits({i}));
  EXPECT_EQ(decoder.counters().missed, 2u);
  for (uint8_t i = 0; i < 3; i++) EXPECT_EQ(decoder.takeIntact(), Bytes{i});
  EXPECT_EQ(decoder.takeIntact(), Bytes{});
}

TEST(RadioDecoder, countsAsDamagedAndNotAsMissedABrokenPacketWithoutASlot) {
  Decoder decoder;
  for (uint8_t i = 0; i < 3; i++) decoder.add(reference::packetBits({i}));
  Bits broken = reference::packetBits({7, 7, 7});
  broken[60] = !broken[60];
  broken[66] = !broken[66];
  decoder.add(broken);
  EXPECT_EQ(decoder.counters().missed, 0u);
  EXPECT_EQ(decoder.counters().damaged, 1u);
}

TEST(RadioDecoder, countsAsMissedThePacketThatItAbandons) {
  Decoder decoder;
  const Bits bits = reference::packetBits({1, 2, 3, 4});
  decoder.add(Bits(bits.begin(), bits.begin() + 70));
  decoder.abandon();
  decoder.add(Bits(bits.begin() + 70, bits.end()));
  EXPECT_EQ(decoder.counters().missed, 1u);
  decoder.add(bits);
  EXPECT_EQ(decoder.takeIntact(), (Bytes{1, 2, 3, 4}));
}

TEST(RadioDecoder, abandonsNothingBetweenPackets) {
  Decoder decoder;
  decoder.abandon();
  EXPECT_EQ(decoder.counters().missed, 0u);
}
