// Copies that relays send: their CRC tells the path behind them (SPEC 6).
#include <gtest/gtest.h>

#include "radio/RadioEncoder.h"
#include "support/Damage.h"
#include "support/Vectors.h"

namespace {

Bits encode(const Bytes &payload, uint8_t path) {
  uint8_t packet[80];
  javinolib::RadioEncoder encoder;
  EXPECT_TRUE(
      encoder.start(payload.data(), static_cast<uint8_t>(payload.size()), javinolib::Trailer::NONE, packet, path));
  Bits bits;
  while (encoder.hasNext()) bits.push_back(encoder.next());
  return bits;
}

}  // namespace

TEST(Copies, areSentAsTheVectorsSay) {
  for (const CopyVector &vector : copyVectors()) EXPECT_EQ(encode(vector.payload, vector.path), vector.bits);
}

TEST(Copies, areTakenAndTellTheirHops) {
  for (const CopyVector &vector : copyVectors()) {
    MendingDecoder decoder;
    decoder.addAll(vector.bits);
    ASSERT_EQ(decoder.take(), javinolib::Mender::WHOLE);
    EXPECT_EQ(decoder.payload, vector.payload);
    EXPECT_EQ(decoder.mender.path(), vector.path);
    EXPECT_FALSE(decoder.mender.hasMended());
    EXPECT_FALSE(decoder.mender.isDoubtful());
  }
}

// No vector has a path from which another one differs in two bits only (SPEC 6).
TEST(Copies, areMendedWhereverABitIsWrong) {
  for (const CopyVector &vector : copyVectors()) {
    for (size_t i = 60; i < vector.bits.size(); i++) {
      Bits bits = vector.bits;
      bits[i].flip();
      MendingDecoder decoder;
      decoder.addAll(bits);
      ASSERT_EQ(decoder.take(), javinolib::Mender::WHOLE) << "bit " << i;
      EXPECT_EQ(decoder.payload, vector.payload) << "bit " << i;
      EXPECT_EQ(decoder.mender.path(), vector.path) << "bit " << i;
    }
  }
}

// A copy and the packet itself, each with more wrong bits than can be mended alone.
TEST(Copies, areCombinedWithDamagedOnesOfOtherHops) {
  std::mt19937 random(7);
  int alone = 0;
  int both = 0;
  for (int i = 0; i < 300; i++) {
    Bytes payload(40);
    for (uint8_t &byte : payload) byte = static_cast<uint8_t>(random());
    MendingDecoder decoder;
    decoder.addAll(damaged(encode(payload, 0), 0.01, random));
    if (decoder.take() == javinolib::Mender::WHOLE) continue;
    const Bits second = damaged(encode(payload, 1), 0.01, random);
    MendingDecoder other;
    other.addAll(second);
    if (other.take() == javinolib::Mender::WHOLE) alone++;
    decoder.addAll(second);
    if (decoder.take() != javinolib::Mender::WHOLE) continue;
    EXPECT_EQ(decoder.payload, payload);
    EXPECT_LE(decoder.mender.path(), 1) << "those of either";
    both++;
  }
  EXPECT_GT(both, alone);
}
