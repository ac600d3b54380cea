#include <gtest/gtest.h>

#include <random>

#include "support/Decoder.h"
#include "support/Vectors.h"

namespace {

// A refused packet is counted, is not queued, and does not cost the packet behind it.
void expectRefused(const Bits &bits, const std::string &what) {
  Decoder decoder;
  decoder.add(bits);
  decoder.add(Bits(10, false));
  decoder.endOfSignal();
  EXPECT_EQ(decoder.take().symbols, 0) << what;
  EXPECT_GE(decoder.counters().damaged, 1u) << what;
  decoder.add(reference::packetBits(GOOD));
  EXPECT_EQ(decoder.takeIntact(), GOOD) << what;
}

}  // namespace

TEST(RadioDecoder, refusesTheInvalidVectors) {
  for (const InvalidRadioVector &vector : invalidRadioVectors()) {
    Decoder decoder;
    decoder.add(vector.bits);
    decoder.add(Bits(10, false));
    decoder.endOfSignal();
    EXPECT_EQ(decoder.takeIntact(), Bytes()) << vector.why;
    decoder.take();
    decoder.add(reference::packetBits(GOOD));
    EXPECT_EQ(decoder.takeIntact(), GOOD) << vector.why;
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

TEST(RadioDecoder, refusesEachTruncationThatTheEndOfTheSignalShows) {
  const Bits whole = reference::packetBits({'R', 'O', 'M', 'A', 0, 0xFF});
  for (size_t length = 60; length < whole.size() - 10; length++) {
    expectRefused(Bits(whole.begin(), whole.begin() + length), "cut after bit " + std::to_string(length));
  }
}

TEST(RadioDecoder, hasCountedATruncatedPacketOnceAtTheEndOfTheSignal) {
  const Bits whole = reference::packetBits({'R', 'O', 'M', 'A', 0, 0xFF});
  for (size_t length = 48; length < whole.size() - 6; length++) {
    for (bool level : {false, true}) {
      Decoder decoder;
      decoder.add(Bits(whole.begin(), whole.begin() + length));
      decoder.add(Bits(10, level));
      decoder.endOfSignal();
      EXPECT_EQ(decoder.counters().damaged + (decoder.take().symbols != 0), 1u) << "cut after bit " << length;
    }
  }
}

TEST(RadioDecoder, countsNothingAtTheEndOfASignalBetweenPackets) {
  Decoder decoder;
  decoder.add(reference::packetBits(GOOD));
  decoder.endOfSignal();
  EXPECT_EQ(decoder.counters().damaged, 0u);
  EXPECT_EQ(decoder.takeIntact(), GOOD);
}

TEST(RadioDecoder, givesRandomBytesAsTheyAre) {
  std::mt19937 random(5);
  Decoder decoder;
  int queued = 0;
  for (int i = 0; i < 20000; i++) {
    Bytes bytes(random() % 84 + 1);
    for (uint8_t &byte : bytes) byte = static_cast<uint8_t>(random());
    bytes[0] = static_cast<uint8_t>(random() % 84);
    decoder.add(reference::lineBits(bytes));
    decoder.endOfSignal();
    javinolib::RadioPacket packet = decoder.take();
    if (packet.symbols == 0 || bytes[0] > bytes.size()) continue;
    queued++;
    const Bytes sent(bytes.begin(), bytes.begin() + bytes[0]);
    EXPECT_EQ(packet.path() == 0, sent == reference::packetOf(Bytes(sent.begin() + 1, sent.end() - 2)));
    packet.makeBytes(packet.count());
    EXPECT_EQ(Bytes(packet.bytes(), packet.bytes() + packet.bytes()[0]), sent);
  }
  EXPECT_GT(queued, 5000);
}

TEST(RadioDecoder, survivesAMillionRandomBits) {
  std::mt19937 random(6);
  Decoder decoder;
  for (int i = 0; i < 1000000; i++) {
    decoder.add(Bits(1, random() & 1));
    EXPECT_EQ(decoder.takeIntact(), Bytes());
  }
  decoder.endOfSignal();
  decoder.add(reference::packetBits(GOOD));
  EXPECT_EQ(decoder.takeIntact(), GOOD);
}
