#include <framing/Frame.h>
#include <gtest/gtest.h>

#include "FrameErrors.h"
#include "support/Addresses.h"
#include "support/Vectors.h"

using javinolib::Frame;
using javinolib::FrameError;

TEST(Frame, reads_all_valid_vectors) {
  for (const Vector &vector : vectors("frames.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    const Bytes bytes = vector.bytes("frame");
    Frame frame;
    ASSERT_EQ(FrameError::NONE, Frame::parse(bytes.data(), static_cast<uint16_t>(bytes.size()), frame));
    EXPECT_EQ(addressOf(vector.text("destination")), frame.destination);
    EXPECT_EQ(addressOf(vector.text("origin")), frame.origin);
    EXPECT_EQ(vector.bytes("message"), Bytes(frame.message, frame.message + frame.length));
  }
}

TEST(Frame, writes_the_header_of_all_valid_vectors) {
  for (const Vector &vector : vectors("frames.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    const Bytes message = vector.bytes("message");
    Bytes header(javinolib::HEADER_LENGTH);
    Frame::writeHeader(header.data(), addressOf(vector.text("destination")), addressOf(vector.text("origin")),
                       static_cast<uint16_t>(message.size()));
    EXPECT_EQ(vector.text("frame"), toHex(header + message));
  }
}

TEST(Frame, refuses_all_invalid_vectors_for_their_reason) {
  for (const Vector &vector : vectors("frames.json", "invalid")) {
    SCOPED_TRACE(vector.toString());
    const Bytes bytes = vector.bytes("bytes");
    Frame frame;
    EXPECT_EQ(vector.text("error"), nameOf(Frame::parse(bytes.data(), static_cast<uint16_t>(bytes.size()), frame)));
  }
}
