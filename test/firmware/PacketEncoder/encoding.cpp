#include <framing/PacketEncoder.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/Reference.h"
#include "support/Vectors.h"

namespace {

Bytes encode(Bytes bytes) {
  const size_t length = bytes.size();
  bytes.resize(length + 2);
  javinolib::PacketEncoder encoder;
  encoder.start(bytes.data(), static_cast<uint16_t>(length));
  Bytes encoded;
  while (!encoder.done()) encoded.push_back(encoder.next());
  return encoded;
}

Bytes withCrc(const Bytes &inner) {
  const uint16_t crc = reference::crc(inner);
  return inner + Bytes{static_cast<uint8_t>(crc), static_cast<uint8_t>(crc >> 8)};
}

}  // namespace

TEST(PacketEncoder, makes_all_valid_vectors) {
  for (const Vector &vector : vectors("packets.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    const Bytes inner = Bytes{static_cast<uint8_t>(vector.number("sequence"))} + vector.bytes("frame");
    EXPECT_EQ(vector.text("packet"), toHex(encode(inner)));
  }
}

TEST(PacketEncoder, is_done_before_anything_was_started) { EXPECT_TRUE(javinolib::PacketEncoder().done()); }

TEST(PacketEncoder, encodes_runs_of_every_length_around_a_full_block) {
  for (size_t length = 0; length <= 522; length++) {
    for (int zeroes = 0; zeroes <= 2; zeroes++) {
      const Bytes bytes = Bytes(length, 0x55) + Bytes(zeroes, 0);
      ASSERT_EQ(reference::cobs(withCrc(bytes)) + Bytes{0}, encode(bytes)) << length << " and " << zeroes;
    }
  }
}

TEST(PacketEncoder, random_bytes_come_back_and_no_zero_is_inside) {
  RandomBytes random(5);
  for (int i = 0; i < 1000; i++) {
    Bytes bytes = random.bytes(random.number(523));
    for (uint8_t &byte : bytes) byte = random.number(4) == 0 ? 0 : byte;
    Bytes encoded = encode(bytes);
    ASSERT_EQ(0, encoded.back());
    encoded.pop_back();
    ASSERT_EQ(Bytes::difference_type(0), std::count(encoded.begin(), encoded.end(), 0));
    ASSERT_EQ(withCrc(bytes), reference::cobsDecoded(encoded));
  }
}

TEST(PacketEncoder, the_longest_packet_takes_528_bytes) { EXPECT_EQ(528u, encode(Bytes(522, 1)).size()); }
