#include <gtest/gtest.h>
#include <secure/Envelope.h>

#include "support/TestBoard.h"
#include "support/Vectors.h"

using javinolib::Envelope;

namespace {

javinolib::DerivedKeys keysOf(const Vector &vector) {
  javinolib::DerivedKeys keys;
  keys.derive(vector.bytes("key").data());
  return keys;
}

}  // namespace

TEST(Envelope, seals_all_valid_vectors) {
  for (const Vector &vector : vectors("envelopes.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    EXPECT_EQ(vector.text("frame"), toHex(sealed(vector.bytes("key"), vector.text("destination"), vector.text("origin"),
                                                 vector.bytes("nonce"), textOf(vector.bytes("content")))));
  }
}

TEST(Envelope, opens_all_valid_vectors) {
  for (const Vector &vector : vectors("envelopes.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    const javinolib::DerivedKeys keys = keysOf(vector);
    const Envelope envelope(keys);
    Bytes frame = vector.bytes("frame");
    const uint16_t length = static_cast<uint16_t>(frame.size());
    ASSERT_TRUE(envelope.isAuthentic(frame.data(), length));
    EXPECT_EQ(vector.bytes("nonce"), Bytes(frame.begin() + Envelope::NONCE_AT, frame.begin() + Envelope::CONTENT_AT));
    const uint16_t opened = envelope.open(frame.data(), length);
    const uint8_t *content = frame.data() + Envelope::CONTENT_AT;
    EXPECT_EQ(vector.text("content"), toHex(Bytes(content, content + opened)));
  }
}

TEST(Envelope, refuses_all_invalid_vectors) {
  for (const Vector &vector : vectors("envelopes.json", "invalid")) {
    SCOPED_TRACE(vector.toString());
    const javinolib::DerivedKeys keys = keysOf(vector);
    const Bytes frame = vector.bytes("frame");
    EXPECT_FALSE(Envelope(keys).isAuthentic(frame.data(), static_cast<uint16_t>(frame.size())));
  }
}
