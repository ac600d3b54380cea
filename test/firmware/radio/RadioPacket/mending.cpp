#include <gtest/gtest.h>

#include "support/Damage.h"
#include "support/Decoder.h"

namespace {

const Bytes PAYLOAD = {'R', 'O', 'M', 'A', 0, 0xFF};

Bytes contentOf(const javino::RadioPacket &packet) {
  return Bytes(packet.payload(), packet.payload() + packet.payloadLength());
}

javino::RadioPacket decoded(const Bits &bits) {
  Decoder decoder;
  decoder.add(bits);
  decoder.endOfSignal();
  return decoder.take();
}

Bytes randomBytes(size_t length, std::mt19937 &random) {
  Bytes bytes(length);
  for (uint8_t &byte : bytes) byte = static_cast<uint8_t>(random());
  return bytes;
}

}  // namespace

TEST(RadioPacket, mendsEachWrongBitBehindTheCountInPacketsOfEachLength) {
  std::mt19937 random(51);
  for (size_t length = 1; length <= 77; length++) {
    const Bytes payload = randomBytes(length, random);
    const Bits whole = reference::packetBits(payload);
    for (size_t i = 60; i < whole.size(); i += length < 10 ? 1 : 7) {
      Bits bits = whole;
      bits[i] = !bits[i];
      javino::RadioPacket packet = decoded(bits);
      ASSERT_EQ(packet.bytes[0], length + 3) << "bit " << i;
      ASSERT_TRUE(packet.mend()) << length << " bytes, bit " << i;
      EXPECT_TRUE(packet.isIntact());
      EXPECT_EQ(contentOf(packet), payload) << "bit " << i;
    }
  }
}

TEST(RadioPacket, doesNotMendTwoWrongBitsOfOneSymbolOrOfTwo) {
  const Bits whole = reference::packetBits(PAYLOAD);
  for (size_t i = 60; i < whole.size(); i++) {
    for (size_t k = i + 1; k < whole.size(); k++) {
      Bits bits = whole;
      bits[i] = !bits[i];
      bits[k] = !bits[k];
      javino::RadioPacket packet = decoded(bits);
      if (packet.bytes[0] == 0) continue;
      const bool whole = packet.wrongNibble == javino::RadioPacket::NO_NIBBLE;
      EXPECT_FALSE(whole ? packet.isIntact() : packet.mend()) << "bits " << i << " and " << k;
    }
  }
}

// Of 2^16 CRCs one is right for each of the up to four candidates: one packet of 20 000 is mended into a wrong one.
TEST(RadioPacket, doesNotMendWhereTheCrcIsWrong) {
  std::mt19937 random(52);
  int mended = 0;
  const int packets = 20000;
  for (int i = 0; i < packets; i++) {
    Bytes bytes = reference::packetOf(randomBytes(20, random));
    bytes[1] ^= static_cast<uint8_t>(random() % 255 + 1);
    Bits bits = reference::lineBits(bytes);
    const size_t wrong = 72 + random() % (bits.size() - 72);
    bits[wrong] = !bits[wrong];
    javino::RadioPacket packet = decoded(bits);
    if (packet.mend()) mended++;
  }
  EXPECT_LE(mended, 4);
}

// bench/native/mending.cpp does so with a million.
TEST(RadioPacket, makesNoWrongPayloadOfThirtyThousandDamagedPackets) {
  std::mt19937 random(54);
  for (double rate : {1e-3, 3e-3, 1e-2}) {
    Damage damage;
    while (damage.damaged() < 10000) damage.tryPacket(randomBytes(40, random), rate, random);
    EXPECT_GT(damage.mended, 0u) << rate;
    EXPECT_EQ(damage.wrong, 0u) << rate;
  }
}
