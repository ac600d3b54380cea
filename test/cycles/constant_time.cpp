// No number of cycles depends on keys or data.
#include <gtest/gtest.h>

#include <set>

#include "../firmware/support/Reference.h"
#include "TestMega.h"

namespace {

const int KEYS = 1000;

Bytes header(size_t length) {
  const Bytes frame = reference::frame("SUHO", "ROMA", Bytes(length));
  return Bytes(frame.begin(), frame.end() - static_cast<std::ptrdiff_t>(length));
}

}  // namespace

TEST(ConstantTime, key_schedule) {
  RandomBytes random(1);
  std::set<uint64_t> cycles;
  for (int i = 0; i < KEYS; i++) cycles.insert(perform(Mailbox::EXPAND_KEY, random.bytes(16), {}, {}).cycles);
  EXPECT_EQ(1u, cycles.size());
}

TEST(ConstantTime, aes_block) {
  RandomBytes random(2);
  std::set<uint64_t> cycles;
  for (int i = 0; i < KEYS; i++) {
    const Bytes key = random.bytes(16);
    cycles.insert(perform(Mailbox::ENCRYPT_BLOCK, key, {}, random.bytes(16)).cycles);
  }
  EXPECT_EQ(1u, cycles.size());
}

TEST(ConstantTime, cmac) {
  RandomBytes random(3);
  std::set<uint64_t> cycles;
  for (int i = 0; i < KEYS; i++) {
    const Bytes key = random.bytes(16);
    cycles.insert(perform(Mailbox::COMPUTE_CMAC, key, {}, random.bytes(32)).cycles);
  }
  EXPECT_EQ(1u, cycles.size());
}

TEST(ConstantTime, derived_keys) {
  RandomBytes random(4);
  std::set<uint64_t> cycles;
  for (int i = 0; i < KEYS / 10; i++) cycles.insert(perform(Mailbox::DERIVE_KEYS, random.bytes(16), {}, {}).cycles);
  EXPECT_EQ(1u, cycles.size());
}

TEST(ConstantTime, seal_and_open) {
  RandomBytes random(5);
  std::set<uint64_t> sealing;
  std::set<uint64_t> opening;
  for (int i = 0; i < KEYS; i++) {
    const Bytes kenc = random.bytes(16);
    const Bytes kmac = random.bytes(16);
    const Bytes nonce = random.bytes(6);
    const Outcome sealed = perform(Mailbox::SEAL, kenc, kmac, header(16) + random.bytes(16), nonce);
    const Outcome opened = perform(Mailbox::OPEN, kenc, kmac, sealed.bytes(sealed.mailbox.length));
    ASSERT_EQ(16, opened.mailbox.length);
    sealing.insert(sealed.cycles);
    opening.insert(opened.cycles);
  }
  EXPECT_EQ(1u, sealing.size());
  EXPECT_EQ(1u, opening.size());
}

TEST(ConstantTime, forged_tag_wherever_it_differs) {
  RandomBytes random(6);
  const Bytes kenc = random.bytes(16);
  const Bytes kmac = random.bytes(16);
  const Outcome sealed = perform(Mailbox::SEAL, kenc, kmac, header(16) + random.bytes(16), random.bytes(6));
  const Bytes frame = sealed.bytes(sealed.mailbox.length);
  std::set<uint64_t> cycles;
  for (size_t i = 1; i <= 8; i++) {
    Bytes forged = frame;
    forged[frame.size() - i] ^= 0x10;
    const Outcome opened = perform(Mailbox::OPEN, kenc, kmac, forged);
    ASSERT_EQ(0xFFFF, opened.mailbox.length);
    cycles.insert(opened.cycles);
  }
  EXPECT_EQ(1u, cycles.size());
}
