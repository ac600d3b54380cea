#include <gtest/gtest.h>

#include <random>

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

TEST(RadioDecoder, needsHalfOfTheTraining) {
  Decoder decoder;
  const Bits bits = reference::packetBits({1, 2, 3});
  decoder.add(Bits(bits.begin() + 24, bits.end()));
  EXPECT_EQ(decoder.takeIntact(), (Bytes{1, 2, 3}));
}

// Four places make an early or late start out of three wrong bits in the start symbol.
TEST(RadioDecoder, bearsThreeWrongBitsOfTrainingAndStart) {
  std::mt19937 random(61);
  int lost = 0;
  const int packets = 3000;
  for (int i = 0; i < packets; i++) {
    Bits bits = reference::packetBits({1, 2, 3});
    for (size_t place : {12 + random() % 36, 12 + random() % 36, 12 + random() % 36}) bits[place] = !bits[place];
    Decoder decoder;
    decoder.add(bits);
    if (decoder.takeIntact() != (Bytes{1, 2, 3})) lost++;
  }
  EXPECT_LE(lost, packets / 300);
}

TEST(RadioDecoder, seldomFindsAStartInNoise) {
  std::mt19937 random(62);
  Decoder decoder;
  const int seconds = 3600;
  for (int i = 0; i < 2000 * seconds; i++) decoder.add(Bits(1, random() & 1));
  EXPECT_LE(decoder.counters().damaged, 6u);  // one in 73 minutes, and one in 140 with the last 24 bits right
}

// A false start of which nothing is to be had: a packet that follows takes its place, however soon.
TEST(RadioDecoder, losesNoPacketBehindAFalseStart) {
  std::mt19937 random(63);
  const Bits start = reference::lineBits({});
  const Bits packet = reference::packetBits(GOOD);
  int lost = 0;
  int tried = 0;
  for (size_t noise = 0; noise < 400; noise++) {
    for (int i = 0; i < 20; i++) {
      Decoder decoder;
      Bits bits(start.begin(), start.end());
      for (int wrong = 0; wrong < 3; wrong++) bits[12 + 12 * wrong + random() % 12].flip();
      for (size_t k = 0; k < noise; k++) bits.push_back(random() & 1);
      decoder.add(bits);
      decoder.add(packet);
      decoder.add(Bits(10, false));
      decoder.endOfSignal();
      Bytes found;
      for (javinolib::RadioPacket each = decoder.take(); each.symbols != 0; each = decoder.take()) {
        if (each.path() >= javinolib::RadioPacket::NO_PATH) continue;
        each.makeBytes(each.count());
        found = Bytes(each.payload(), each.payload() + each.payloadLength());
      }
      tried++;
      if (found != GOOD) lost++;
    }
  }
  EXPECT_EQ(lost, 0) << "of " << tried;
}

TEST(RadioDecoder, keepsAPacketWhoseContentLooksLikeAStart) {
  const std::string text = "////ROMABg33333t333tx333333t";
  const Bytes payload(text.begin(), text.end());
  for (size_t wrong = 12; wrong < 48; wrong++) {
    Bits bits = reference::packetBits(payload);
    bits[wrong].flip();
    Decoder decoder;
    decoder.add(bits);
    EXPECT_EQ(decoder.takeIntact(), payload) << "bit " << wrong;
  }
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
  for (uint8_t i = 0; i < 4; i++) decoder.add(reference::packetBits({i}));
  EXPECT_EQ(decoder.counters().missed, 2u);
  for (uint8_t i = 0; i < 2; i++) EXPECT_EQ(decoder.takeIntact(), Bytes{i});
  EXPECT_EQ(decoder.takeIntact(), Bytes{});
}

TEST(RadioDecoder, countsAsDamagedAndNotAsMissedABrokenPacketWithoutASlot) {
  Decoder decoder;
  for (uint8_t i = 0; i < 2; i++) decoder.add(reference::packetBits({i}));
  const Bits broken = reference::packetBits({7, 7, 7});
  decoder.add(Bits(broken.begin(), broken.end() - 20));
  decoder.add(Bits(10, false));
  decoder.endOfSignal();
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
