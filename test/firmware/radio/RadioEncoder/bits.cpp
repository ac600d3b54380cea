#include <gtest/gtest.h>

#include "radio/RadioEncoder.h"
#include "support/Vectors.h"

using javinolib::RadioEncoder;

namespace {

Bits encode(const Bytes &payload) {
  uint8_t packet[80];
  RadioEncoder encoder;
  EXPECT_TRUE(encoder.start(payload.data(), static_cast<uint8_t>(payload.size()), javinolib::Trailer::NONE, packet));
  Bits bits;
  while (encoder.hasNext()) bits.push_back(encoder.next());
  return bits;
}

}  // namespace

TEST(RadioEncoder, givesTheBitsOfTheVectors) {
  for (const RadioVector &vector : radioVectors()) EXPECT_EQ(encode(vector.payload), vector.bits);
}

TEST(RadioEncoder, givesTheBitsOfTheSpecificationForEachLength) {
  for (size_t length = 1; length <= 77; length++) {
    Bytes payload;
    for (size_t i = 0; i < length; i++) payload.push_back(static_cast<uint8_t>(i * 37 + length));
    const Bits bits = encode(payload);
    EXPECT_EQ(bits, reference::packetBits(payload)) << length << " bytes";
    EXPECT_EQ(bits.size(), 84 + 12 * length);
  }
}

TEST(RadioEncoder, givesTheBitsOfTheSpecificationForEachByte) {
  for (int byte = 0; byte < 256; byte++) {
    const Bytes payload(1, static_cast<uint8_t>(byte));
    EXPECT_EQ(encode(payload), reference::packetBits(payload)) << byte;
  }
}

TEST(RadioEncoder, refusesNoPayloadAndTooLongOnes) {
  const Bytes payload(255, 0x55);
  uint8_t packet[80];
  RadioEncoder encoder;
  for (uint8_t length : {0, 78, 80, 255}) {
    EXPECT_FALSE(encoder.start(payload.data(), length, javinolib::Trailer::NONE, packet)) << int(length);
    EXPECT_FALSE(encoder.hasNext());
  }
}

TEST(RadioEncoder, staysOffAfterTheLastBit) {
  const Bytes payload(1, 0x55);
  uint8_t packet[80];
  RadioEncoder encoder;
  ASSERT_TRUE(encoder.start(payload.data(), 1, javinolib::Trailer::NONE, packet));
  for (int i = 0; i < 96; i++) encoder.next();
  EXPECT_FALSE(encoder.hasNext());
  EXPECT_FALSE(encoder.next());
}

TEST(RadioEncoder, startsAnewInTheMiddleOfAPacket) {
  const Bytes first(20, 0xA5), second(3, 0x17);
  uint8_t packet[80];
  RadioEncoder encoder;
  encoder.start(first.data(), 20, javinolib::Trailer::NONE, packet);
  for (int i = 0; i < 101; i++) encoder.next();
  encoder.start(second.data(), 3, javinolib::Trailer::NONE, packet);
  Bits bits;
  while (encoder.hasNext()) bits.push_back(encoder.next());
  EXPECT_EQ(bits, reference::packetBits(second));
}
