#include <gtest/gtest.h>
#include <secure/Envelope.h>

#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::Envelope;

namespace {

bool isAuthentic(const Bytes &frame) {
  javinolib::DerivedKeys keys;
  keys.derive(KEY.data());
  return Envelope(keys).isAuthentic(frame.data(), static_cast<uint16_t>(frame.size()));
}

}  // namespace

TEST(Envelope, every_changed_bit_is_noticed) {
  const Bytes frame = sealed(KEY, "SUHO", "SUPP", Bytes(6, 1), "tell;someoneNeedHelp");
  ASSERT_TRUE(isAuthentic(frame));
  for (size_t bit = 0; bit < frame.size() * 8; bit++) {
    Bytes changed = frame;
    changed[bit / 8] = static_cast<uint8_t>(changed[bit / 8] ^ 1 << bit % 8);
    EXPECT_FALSE(isAuthentic(changed)) << bit;
  }
}

TEST(Envelope, every_truncation_and_any_extension_is_noticed) {
  const Bytes frame = sealed(KEY, "SUHO", "SUPP", Bytes(6, 1), "tell;someoneNeedHelp");
  for (size_t length = 0; length < frame.size(); length++) {
    EXPECT_FALSE(isAuthentic(Bytes(frame.begin(), frame.begin() + length))) << length;
  }
  EXPECT_FALSE(isAuthentic(frame + Bytes{0}));
}

TEST(Envelope, random_frames_are_never_authentic) {
  RandomBytes random(6);
  for (int i = 0; i < 500; i++) EXPECT_FALSE(isAuthentic(random.bytes(random.number(78))));
}

TEST(Envelope, equal_contents_look_different_under_another_nonce) {
  const Bytes some = sealed(KEY, "SUHO", "SUPP", {0, 0, 1, 0, 0, 0}, "tell;help");
  const Bytes other = sealed(KEY, "SUHO", "SUPP", {0, 0, 1, 0, 0, 1}, "tell;help");
  EXPECT_NE(Bytes(some.begin() + 16, some.end()), Bytes(other.begin() + 16, other.end()));
}
