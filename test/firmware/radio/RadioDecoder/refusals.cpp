#include <gtest/gtest.h>

#include <random>

#include "support/Decoder.h"
#include "support/Vectors.h"

namespace {

const Bytes GOOD = {'g', 'o', 'o', 'd'};

// What was refused is counted, is not delivered, and does not cost the packet behind it.
void expectRefused(const Bits &bits, const std::string &what) {
  Decoder decoder;
  decoder.add(bits);
  decoder.add(Bits(12, false));
  EXPECT_EQ(decoder.counters.received, 0u) << what;
  EXPECT_GE(decoder.counters.damaged, 1u) << what;
  decoder.add(reference::packetBits(GOOD));
  EXPECT_EQ(decoder.take(), GOOD) << what;
}

}  // namespace

TEST(RadioDecoder, refusesTheInvalidVectors) {
  for (const InvalidRadioVector &vector : invalidRadioVectors()) {
    Decoder decoder;
    decoder.add(vector.bits);
    decoder.add(Bits(12, false));
    EXPECT_EQ(decoder.counters.received, 0u) << vector.why;
    decoder.add(reference::packetBits(GOOD));
    EXPECT_EQ(decoder.take(), GOOD) << vector.why;
  }
}

TEST(RadioDecoder, refusesEachCountOutsideOfFourToEighty) {
  for (int count = 0; count < 256; count++) {
    if (count >= 4 && count <= 80) continue;
    Bytes packet(1, static_cast<uint8_t>(count));
    packet.resize(20, 0x55);
    expectRefused(reference::lineBits(packet), "count " + std::to_string(count));
  }
}

TEST(RadioDecoder, refusesEachChangedBitAfterTheStart) {
  const Bits whole = reference::packetBits({'R', 'O', 'M', 'A', 0, 0xFF});
  for (size_t i = 48; i < whole.size(); i++) {
    Bits bits = whole;
    bits[i] = !bits[i];
    expectRefused(bits, "bit " + std::to_string(i));
  }
}

TEST(RadioDecoder, refusesEachTruncation) {
  const Bits whole = reference::packetBits({'R', 'O', 'M', 'A', 0, 0xFF});
  for (size_t length = 48; length < whole.size() - 3; length++) {
    expectRefused(Bits(whole.begin(), whole.begin() + length), "cut after bit " + std::to_string(length));
  }
}

TEST(RadioDecoder, hasRefusedATruncatedPacketAfterTenBitsOfEitherLevel) {
  const Bits whole = reference::packetBits({'R', 'O', 'M', 'A', 0, 0xFF});
  for (size_t length = 48; length < whole.size() - 3; length++) {
    for (bool level : {false, true}) {
      Decoder decoder;
      decoder.add(Bits(whole.begin(), whole.begin() + length));
      decoder.add(Bits(10, level));
      EXPECT_EQ(decoder.counters.damaged + decoder.counters.received, 1u) << "cut after bit " << length;
    }
  }
}

TEST(RadioDecoder, deliversNothingWithAWrongCrcFromRandomBytes) {
  std::mt19937 random(5);
  Decoder decoder;
  for (int i = 0; i < 20000; i++) {
    Bytes bytes(random() % 84 + 1);
    for (uint8_t &byte : bytes) byte = static_cast<uint8_t>(random());
    bytes[0] = static_cast<uint8_t>(random() % 84);
    const Bytes payload = bytes.size() > 3 ? Bytes(bytes.begin() + 1, bytes.end() - 2) : Bytes();
    decoder.add(reference::lineBits(bytes));
    const Bytes received = decoder.take();
    if (!received.empty()) {
      EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + bytes[0]), reference::packetOf(received));
    }
  }
  EXPECT_GT(decoder.counters.damaged, 10000u);
}

TEST(RadioDecoder, survivesAMillionRandomBits) {
  std::mt19937 random(6);
  Decoder decoder;
  for (int i = 0; i < 1000000; i++) decoder.add(Bits(1, random() & 1));
  decoder.add(Bits(12, false));
  decoder.add(reference::packetBits(GOOD));
  EXPECT_EQ(decoder.counters.received, 1u);
  EXPECT_EQ(decoder.take(), GOOD);
}
