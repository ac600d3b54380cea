#include <gtest/gtest.h>

#include "support/Damage.h"

TEST(Mender, mendsEachWrongBitOfPacketsOfEachLengthAndLeavesNoDoubtBehindTheCount) {
  std::mt19937 random(51);
  for (size_t length = 1; length <= 77; length++) {
    const Bytes payload = randomBytes(length, random);
    const Bits whole = reference::packetBits(payload);
    for (size_t i = 48; i < whole.size(); i += length < 10 ? 1 : 7) {
      Bits bits = whole;
      bits[i].flip();
      MendingDecoder decoder;
      decoder.addAll(bits);
      ASSERT_EQ(decoder.take(), javinolib::Mender::WHOLE) << length << " bytes, bit " << i;
      EXPECT_EQ(decoder.payload, payload) << "bit " << i;
      EXPECT_TRUE(decoder.mender.hasMended());
      EXPECT_EQ(decoder.mender.isDoubtful(), i < 60) << "bit " << i;
    }
  }
}

TEST(Mender, doubtsWhatItMendsInTwoSymbols) {
  std::mt19937 random(55);
  int whole = 0;
  for (int k = 0; k < 2000; k++) {
    const Bytes payload = randomBytes(40, random);
    Bits bits = reference::packetBits(payload);
    const size_t first = 10 + random() % 80;
    bits[6 * first + random() % 6].flip();
    bits[6 * (first + 1 + random() % 3) + random() % 6].flip();
    MendingDecoder decoder;
    decoder.addAll(bits);
    if (decoder.take() != javinolib::Mender::WHOLE) continue;
    whole++;
    EXPECT_TRUE(decoder.mender.isDoubtful());
    EXPECT_EQ(decoder.payload, payload);
  }
  EXPECT_GT(whole, 1950);
}

// Among 2^16 CRCs twenty are right, one for each path, for each of the up to four candidates: 24 packets of 20 000 are mended into
// wrong ones.
TEST(Mender, doesNotMendWhereTheCrcIsWrong) {
  std::mt19937 random(52);
  int mended = 0;
  const int packets = 20000;
  MendingDecoder decoder;
  for (int i = 0; i < packets; i++) {
    Bytes bytes = reference::packetOf(randomBytes(20, random));
    bytes[1] ^= static_cast<uint8_t>(random() % 255 + 1);
    Bits bits = reference::lineBits(bytes);
    bits[72 + random() % (bits.size() - 72)].flip();
    decoder.addAll(bits);
    if (decoder.take() == javinolib::Mender::WHOLE) mended++;
  }
  EXPECT_LE(mended, 48);
}

// test/lab/bench/native/mending.cpp does so with a million.
TEST(Mender, makesNoWrongPayloadWithoutDoubtOfThirtyThousandDamagedPackets) {
  std::mt19937 random(54);
  for (double rate : {1e-3, 3e-3, 1e-2}) {
    Damage damage;
    while (damage.damaged() < 10000) damage.tryPacket(randomBytes(40, random), rate, random);
    EXPECT_GT(damage.mended, 0u) << rate;
    EXPECT_EQ(damage.wrong, 0u) << rate;
  }
}

TEST(Mender, combinesTwoDamagedCopies) {
  std::mt19937 random(56);
  int second = 0;
  const int packets = 300;
  for (int k = 0; k < packets; k++) {
    const Bytes payload = randomBytes(40, random);
    MendingDecoder decoder;
    for (int attempt = 0; attempt < 2; attempt++) {
      decoder.addAll(damaged(reference::packetBits(payload), 1e-2, random));
      if (decoder.isEmpty() || decoder.take() != javinolib::Mender::WHOLE) continue;
      EXPECT_EQ(decoder.payload, payload);
      second++;
      break;
    }
  }
  EXPECT_GT(second, packets * 9 / 10);
}

TEST(Mender, takesADamagedPacketForTheRightOneThatItKeeps) {
  std::mt19937 random(57);
  int known = 0;
  const int packets = 300;
  for (int k = 0; k < packets; k++) {
    MendingDecoder decoder;
    decoder.keeps = true;
    const Bytes payload = randomBytes(40, random);
    decoder.addAll(reference::packetBits(payload));
    ASSERT_EQ(decoder.take(), javinolib::Mender::WHOLE);
    EXPECT_FALSE(decoder.mender.isDoubtful());
    decoder.addAll(damaged(reference::packetBits(payload), 3e-2, random));
    if (decoder.isEmpty() || decoder.take() != javinolib::Mender::WHOLE) continue;
    known++;
    EXPECT_TRUE(decoder.mender.isDoubtful());
    EXPECT_EQ(decoder.payload, payload);
  }
  EXPECT_GT(known, packets * 9 / 10);
}

// Two sealed contents of one byte: the same header and the same epoch.
TEST(Mender, doesNotTakeAMessageForAnotherOfTheSameSender) {
  std::mt19937 random(58);
  MendingDecoder decoder;
  decoder.keeps = true;
  int wrong = 0;
  for (int k = 0; k < 3000; k++) {
    Bytes payload = {'R', 'O', 'M', 'A', 'C', 'A', 'F', 'E', 'B', '4', 0, 5, 7, 0, 0, static_cast<uint8_t>(k)};
    for (int i = 0; i < 9; i++) payload.push_back(static_cast<uint8_t>(random()));
    decoder.addAll(damaged(reference::packetBits(payload), 2e-2, random));
    while (!decoder.isEmpty()) {
      if (decoder.take() == javinolib::Mender::WHOLE && decoder.payload != payload) wrong++;
    }
  }
  EXPECT_LE(wrong, 6);
}

TEST(Mender, mendsByParity) {
  std::mt19937 random(59);
  for (size_t length : {27u, 40u, 46u, 77u}) {
    int whole = 0;
    const int packets = 200;
    for (int k = 0; k < packets; k++) {
      const Bytes payload = randomBytes(length, random);
      uint8_t room[97];
      javinolib::RadioEncoder encoder;
      ASSERT_TRUE(encoder.start(payload.data(), static_cast<uint8_t>(length), javinolib::Trailer::PARITY, room));
      Bits bits;
      while (encoder.hasNext()) bits.push_back(encoder.next());
      MendingDecoder decoder;
      decoder.addAll(damaged(bits, 1e-2, random));
      if (decoder.isEmpty() || decoder.take() != javinolib::Mender::WHOLE) continue;
      EXPECT_EQ(decoder.payload, payload);
      whole++;
    }
    EXPECT_GT(whole, packets * 85 / 100) << length;
  }
}

TEST(Mender, survivesRandomSymbols) {
  std::mt19937 random(60);
  MendingDecoder decoder;
  for (int k = 0; k < 3000; k++) {
    Bytes bytes(random() % 110 + 1);
    for (uint8_t &byte : bytes) byte = static_cast<uint8_t>(random());
    bytes[0] = static_cast<uint8_t>(4 + random() % 77);
    decoder.addAll(damaged(reference::lineBits(bytes), (random() % 10) * 1e-2, random));
    while (!decoder.isEmpty()) {
      decoder.take();
      EXPECT_LE(decoder.steps, 400);
    }
  }
}

// They differ in a digit and in the CRC alone.
TEST(Mender, combinesAFragmentWithTheSameOneThatAsksForAnAnswer) {
  std::mt19937 random(60);
  int tries = 0, whole = 0;
  for (int k = 0; k < 300; k++) {
    Bytes fragment = randomBytes(77, random);
    fragment[3] = 'B';
    Bytes asking = fragment;
    asking[3] = 'J';
    MendingDecoder decoder;
    decoder.addAll(damaged(reference::packetBits(fragment), 2e-2, random));
    if (decoder.isEmpty() || decoder.take() == javinolib::Mender::WHOLE) continue;
    decoder.addAll(damaged(reference::packetBits(asking), 2e-2, random));
    tries++;
    if (decoder.isEmpty() || decoder.take() != javinolib::Mender::WHOLE) continue;
    EXPECT_EQ(decoder.payload, asking);
    whole++;
  }
  EXPECT_GT(whole, tries * 6 / 10) << "of " << tries;
}
