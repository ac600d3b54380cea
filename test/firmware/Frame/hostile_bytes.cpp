#include <framing/Frame.h>
#include <gtest/gtest.h>

#include "support/Bytes.h"
#include "support/Reference.h"

using javinolib::Frame;
using javinolib::FrameError;

// The bytes are copied to a heap block of just their size, so that the sanitizer sees any byte read beyond them.
TEST(Frame, random_bytes_are_refused_or_are_what_they_say) {
  RandomBytes random(1);
  for (int i = 0; i < 20000; i++) {
    const Bytes bytes = random.bytes(random.number(40));
    Frame frame;
    if (Frame::parse(bytes.data(), static_cast<uint16_t>(bytes.size()), frame) == FrameError::NONE) {
      EXPECT_EQ(bytes.size(), frame.length + 10u);
    }
  }
}

TEST(Frame, every_truncation_and_every_extension_is_refused) {
  const Bytes whole = reference::frame("////", "CAFE", bytesOf("Hello!"));
  for (size_t length = 0; length < whole.size(); length++) {
    const Bytes part(whole.begin(), whole.begin() + length);
    Frame frame;
    EXPECT_EQ(length < 10 ? FrameError::TOO_SHORT : FrameError::SIZE_MISMATCH,
              Frame::parse(part.data(), static_cast<uint16_t>(length), frame));
  }
  const Bytes longer = whole + Bytes{'!'};
  Frame frame;
  EXPECT_EQ(FrameError::SIZE_MISMATCH, Frame::parse(longer.data(), static_cast<uint16_t>(longer.size()), frame));
}

TEST(Frame, every_size_from_0_to_511_is_read_and_written) {
  for (size_t length = 0; length <= 511; length++) {
    const Bytes bytes = reference::frame("SUHO", "SUPP", Bytes(length, 'x'));
    Frame frame;
    ASSERT_EQ(FrameError::NONE, Frame::parse(bytes.data(), static_cast<uint16_t>(bytes.size()), frame));
    ASSERT_EQ(length, frame.length);
    Bytes header(10);
    Frame::writeHeader(header.data(), frame.destination, frame.origin, frame.length);
    ASSERT_EQ(Bytes(bytes.begin(), bytes.begin() + 10), header);
  }
}
