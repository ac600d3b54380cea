#include <framing/Frame.h>
#include <gtest/gtest.h>

#include "Frame/FrameErrors.h"
#include "support/BufferedDecoder.h"
#include "support/Vectors.h"

using javinolib::PacketDecoder;
using javinolib::PacketEvent;

namespace {

// Every byte but the last must bring about nothing.
PacketEvent decode(PacketDecoder &decoder, const Bytes &packet) {
  for (size_t i = 0; i + 1 < packet.size(); i++) EXPECT_EQ(PacketEvent::NONE, decoder.add(packet[i]));
  return decoder.add(packet.back());
}

std::string outcomeOf(PacketEvent event, const PacketDecoder &decoder) {
  switch (event) {
    case PacketEvent::NONE: return "NONE";
    case PacketEvent::BAD_COBS: return "BAD_COBS";
    case PacketEvent::TOO_LONG: return "TOO_LONG";
    case PacketEvent::TOO_SHORT: return "TOO_SHORT";
    case PacketEvent::BAD_CRC: return "BAD_CRC";
    default: {
      javinolib::Frame frame;
      return nameOf(javinolib::Frame::parse(decoder.frame(), decoder.frameLength(), frame));
    }
  }
}

}  // namespace

TEST(PacketDecoder, decodes_all_valid_vectors_one_after_the_other) {
  BufferedDecoder decoder;
  for (const Vector &vector : vectors("packets.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    ASSERT_EQ(PacketEvent::PACKET, decode(decoder, vector.bytes("packet")));
    EXPECT_EQ(vector.number("sequence"), decoder.sequence());
    EXPECT_EQ(vector.text("frame"), toHex(Bytes(decoder.frame(), decoder.frame() + decoder.frameLength())));
  }
}

TEST(PacketDecoder, refuses_all_invalid_vectors_for_their_reason) {
  BufferedDecoder decoder;
  for (const Vector &vector : vectors("packets.json", "invalid")) {
    SCOPED_TRACE(vector.toString());
    const PacketEvent event = decode(decoder, vector.bytes("packet"));
    EXPECT_EQ(vector.text("error"), outcomeOf(event, decoder));
  }
}
