// A small chip mends one wrong bit of a packet, wherever it is behind the count.

#include <gtest/gtest.h>

#include <random>

#include "radio/Mender.h"
#include "radio/RadioEncoder.h"
#include "support/Bytes.h"

namespace {

using javinolib::Mender;
using javinolib::RadioPacket;
namespace linecode = javinolib::linecode;

const Bytes PAYLOAD = bytesOf("a payload of 23 bytes..");

std::vector<bool> bitsOf(const Bytes &payload, uint8_t hops = 0) {
  RadioPacket packet = RadioPacket();
  javinolib::RadioEncoder encoder;
  encoder.start(payload.data(), static_cast<uint8_t>(payload.size()), javinolib::Trailer::NONE, packet.room, hops);
  std::vector<bool> bits;
  while (encoder.hasNext()) bits.push_back(encoder.next());
  bits.erase(bits.begin(), bits.begin() + linecode::PREAMBLE_SYMBOLS * linecode::BITS_PER_SYMBOL);
  return bits;
}

RadioPacket packetOf(const std::vector<bool> &bits) {
  RadioPacket packet = RadioPacket();
  packet.symbols = static_cast<uint8_t>(bits.size() / linecode::BITS_PER_SYMBOL);
  for (size_t i = 0; i < bits.size(); i++) {
    if (bits[i]) packet.room[i / 8] = static_cast<uint8_t>(packet.room[i / 8] | 1 << i % 8);
  }
  return packet;
}

class SmallMender : public testing::Test {
 protected:
  bool mends(const std::vector<bool> &bits) {
    RadioPacket packet = packetOf(bits);
    mender.begin();
    const Mender::Progress progress = mender.step(packet);
    EXPECT_NE(Mender::PENDING, progress);
    if (progress != Mender::WHOLE) return false;
    payload.assign(packet.payload(), packet.payload() + packet.payloadLength());
    return true;
  }

  std::vector<bool> bits = bitsOf(PAYLOAD);
  Mender mender;
  Bytes payload;
};

}  // namespace

TEST_F(SmallMender, takes_an_intact_packet) {
  ASSERT_TRUE(mends(bits));
  EXPECT_EQ(PAYLOAD, payload);
  EXPECT_FALSE(mender.hasMended());
}

TEST_F(SmallMender, mends_each_wrong_bit_behind_the_count) {
  for (size_t i = 2 * linecode::BITS_PER_SYMBOL; i < bits.size(); i++) {
    bits[i].flip();
    ASSERT_TRUE(mends(bits)) << "bit " << i;
    EXPECT_EQ(PAYLOAD, payload) << "bit " << i;
    EXPECT_TRUE(mender.hasMended());
    EXPECT_FALSE(mender.isDoubtful());
    bits[i].flip();
  }
}

TEST_F(SmallMender, gives_up_a_wrong_count_and_two_wrong_symbols) {
  for (size_t i = 0; i < 2 * linecode::BITS_PER_SYMBOL; i++) {
    bits[i].flip();
    EXPECT_FALSE(mends(bits)) << "bit " << i;
    bits[i].flip();
  }
  bits[20].flip();
  bits[40].flip();
  EXPECT_FALSE(mends(bits));
}

TEST_F(SmallMender, gives_up_where_no_nibble_makes_the_crc_right) {
  const std::vector<bool> other = bitsOf(bytesOf("a payload of 24 bytes.."));
  for (size_t i = 18; i < bits.size() - 24; i++) {
    std::vector<bool> mixed = other;
    std::copy(bits.end() - 24, bits.end(), mixed.end() - 24);  // with the CRC of the first
    mixed[i].flip();
    if (mends(mixed)) {
      EXPECT_EQ(PAYLOAD, payload);
    }
  }
}

TEST_F(SmallMender, bears_any_symbols) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; i++) {
    RadioPacket packet = RadioPacket();
    for (uint8_t &byte : packet.room) byte = static_cast<uint8_t>(random());
    packet.symbols = static_cast<uint8_t>(2 + random() % (RadioPacket::MAX_SYMBOLS - 1));
    mender.begin();
    mender.step(packet);
  }
}

TEST_F(SmallMender, takes_and_mends_copies_of_relays) {
  for (uint8_t hops = 0; hops < 3; hops++) {
    bits = bitsOf(PAYLOAD, hops);
    ASSERT_TRUE(mends(bits));
    EXPECT_EQ(hops, mender.path());
    EXPECT_FALSE(mender.isDoubtful());
    for (size_t i = 2 * linecode::BITS_PER_SYMBOL; i < bits.size(); i++) {
      bits[i].flip();
      ASSERT_TRUE(mends(bits)) << i;
      EXPECT_EQ(PAYLOAD, payload) << i;
      EXPECT_EQ(hops, mender.path()) << i;
      bits[i].flip();
    }
  }
}
