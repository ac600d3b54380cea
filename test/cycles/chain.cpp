// Chains longer than any vector of NIST, against single blocks: the pointers of the assembly pass multiples of 256.
#include <gtest/gtest.h>

#include <algorithm>

#include "TestMega.h"

namespace {

const size_t BLOCK = 16;

// CFB as SP 800-38A section 6.3 has it, from single blocks of the same Mega.
Bytes encrypted(const Bytes &key, Bytes chain, Bytes bytes) {
  for (size_t at = 0; at < bytes.size(); at += BLOCK) {
    chain = perform(Mailbox::ENCRYPT_BLOCK, key, {}, chain).bytes(BLOCK);
    for (size_t i = at; i < std::min(at + BLOCK, bytes.size()); i++) chain[i - at] = bytes[i] ^= chain[i - at];
  }
  return bytes;
}

}  // namespace

TEST(Chain, long_messages_both_ways) {
  RandomBytes random(8);
  for (size_t length : {240, 256, 272, 497, 592, 600}) {
    const Bytes key = random.bytes(16);
    const Bytes iv = random.bytes(16);
    const Bytes plaintext = random.bytes(length);
    const Bytes ciphertext = encrypted(key, iv, plaintext);
    EXPECT_EQ(ciphertext, perform(Mailbox::ENCRYPT_CFB, key, iv, plaintext).bytes(length)) << length;
    EXPECT_EQ(plaintext, perform(Mailbox::DECRYPT_CFB, key, iv, ciphertext).bytes(length)) << length;
  }
}

TEST(Chain, cycles_depend_on_the_length_alone) {
  RandomBytes random(9);
  for (size_t length : {40, 64}) {
    const uint64_t up = perform(Mailbox::ENCRYPT_CFB, Bytes(16), Bytes(16), Bytes(length)).cycles;
    const uint64_t down = perform(Mailbox::DECRYPT_CFB, Bytes(16), Bytes(16), Bytes(length)).cycles;
    for (int i = 0; i < 100; i++) {
      const Bytes key = random.bytes(16);
      const Bytes iv = random.bytes(16);
      const Bytes bytes = random.bytes(length);
      ASSERT_EQ(up, perform(Mailbox::ENCRYPT_CFB, key, iv, bytes).cycles);
      ASSERT_EQ(down, perform(Mailbox::DECRYPT_CFB, key, iv, bytes).cycles);
    }
  }
}
