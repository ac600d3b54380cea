#include <gtest/gtest.h>

#include "support/BufferedDecoder.h"
#include "support/Reference.h"

using javinolib::PacketDecoder;
using javinolib::PacketEvent;

namespace {

struct Tally {
  int packets = 0;
  int refused = 0;
};

Tally feed(PacketDecoder &decoder, const Bytes &bytes) {
  Tally tally;
  for (uint8_t byte : bytes) {
    const PacketEvent event = decoder.add(byte);
    if (event == PacketEvent::PACKET) {
      tally.packets++;
    } else if (event != PacketEvent::NONE) {
      tally.refused++;
    }
  }
  return tally;
}

const Bytes GOOD = reference::packet(7, reference::frame("++++", "++++", bytesOf("Astop")));

}  // namespace

TEST(PacketDecoder, skips_empty_packets_without_a_count) {
  BufferedDecoder decoder;
  const Tally tally = feed(decoder, Bytes(100, 0) + GOOD + Bytes(3, 0));
  EXPECT_EQ(1, tally.packets);
  EXPECT_EQ(0, tally.refused);
}

TEST(PacketDecoder, any_changed_bit_costs_at_most_two_packets_and_the_next_one_is_found) {
  for (size_t bit = 0; bit < GOOD.size() * 8; bit++) {
    Bytes damaged = GOOD;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ 1 << bit % 8);
    BufferedDecoder decoder;
    feed(decoder, damaged + Bytes{0});  // a 0x00 that was lost comes with the next packet
    EXPECT_EQ(1, feed(decoder, GOOD).packets) << "bit " << bit;
  }
}

TEST(PacketDecoder, no_changed_bit_is_taken_for_a_packet) {
  for (size_t bit = 0; bit < GOOD.size() * 8; bit++) {
    Bytes damaged = GOOD;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ 1 << bit % 8);
    BufferedDecoder decoder;
    EXPECT_EQ(0, feed(decoder, damaged + Bytes{0}).packets) << "bit " << bit;
  }
}

TEST(PacketDecoder, any_lost_byte_is_noticed) {
  for (size_t lost = 0; lost + 1 < GOOD.size(); lost++) {
    Bytes damaged = GOOD;
    damaged.erase(damaged.begin() + lost);
    BufferedDecoder decoder;
    const Tally tally = feed(decoder, damaged);
    EXPECT_EQ(0, tally.packets) << lost;
    EXPECT_EQ(1, tally.refused) << lost;
  }
}

TEST(PacketDecoder, a_stream_without_an_end_stays_within_its_buffer) {
  BufferedDecoder decoder;
  EXPECT_EQ(0, feed(decoder, Bytes(100000, 0xFF)).packets);
  EXPECT_EQ(1, feed(decoder, Bytes{0}).refused);
  EXPECT_EQ(1, feed(decoder, GOOD).packets);
}

TEST(PacketDecoder, random_bytes_never_break_it) {
  RandomBytes random(3);
  BufferedDecoder decoder;
  for (int i = 0; i < 300; i++) {
    feed(decoder, random.bytes(random.number(2000)));
    feed(decoder, Bytes{0});
    ASSERT_EQ(1, feed(decoder, GOOD).packets);
  }
}

TEST(PacketDecoder, decodes_every_length_of_random_content) {
  RandomBytes random(4);
  BufferedDecoder decoder;
  for (size_t length = 0; length <= 511; length++) {
    const Bytes frame = reference::frame("++++", "++++", random.bytes(length));
    ASSERT_EQ(1, feed(decoder, reference::packet(random.byte(), frame)).packets);
    ASSERT_EQ(frame, Bytes(decoder.frame(), decoder.frame() + decoder.frameLength()));
  }
}
