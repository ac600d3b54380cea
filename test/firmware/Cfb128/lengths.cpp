#include <crypto/Cfb128.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/Vectors.h"

using javinolib::Aes128;
using javinolib::Cfb128;

namespace {

const size_t BLOCK = 16;

Vector longest() {
  const std::vector<Vector> all = vectors("nist.json", "cfb128");
  return *std::max_element(all.begin(), all.end(), [](const Vector &some, const Vector &other) {
    return some.text("plaintext").size() < other.text("plaintext").size();
  });
}

// As SP 800-38A section 6.3 has it, block by block.
Bytes encrypted(const Aes128 &cipher, Bytes chain, Bytes bytes) {
  for (size_t at = 0; at < bytes.size(); at += BLOCK) {
    cipher.encrypt(chain.data());
    for (size_t i = at; i < std::min(at + BLOCK, bytes.size()); i++) chain[i - at] = bytes[i] ^= chain[i - at];
  }
  return bytes;
}

void expectBothWays(const Aes128 &cipher, const Bytes &iv, const Bytes &plaintext, const Bytes &ciphertext) {
  const uint16_t length = static_cast<uint16_t>(plaintext.size());
  Bytes bytes = plaintext;
  Cfb128(cipher, iv.data()).encrypt(bytes.data(), length);
  EXPECT_EQ(ciphertext, bytes) << length;
  Cfb128(cipher, iv.data()).decrypt(bytes.data(), length);
  EXPECT_EQ(plaintext, bytes) << length;
}

}  // namespace

// SP 800-38A F.3.13 and F.3.14. Section 5.2 wants whole segments; a short last one is the beginning of a whole one.
TEST(Cfb128, a_short_last_block_is_the_beginning_of_a_whole_one) {
  const Vector vector = longest();
  const Aes128 cipher(vector.bytes("key").data());
  const Bytes plaintext = vector.bytes("plaintext");
  const Bytes ciphertext = vector.bytes("ciphertext");
  for (size_t length = 0; length <= plaintext.size(); length++) {
    const auto end = static_cast<long>(length);
    expectBothWays(cipher, vector.bytes("iv"), Bytes(plaintext.begin(), plaintext.begin() + end),
                   Bytes(ciphertext.begin(), ciphertext.begin() + end));
  }
}

TEST(Cfb128, chains_messages_of_any_length) {
  RandomBytes random(8);
  const Aes128 cipher(random.bytes(BLOCK).data());
  for (size_t length : {79, 80, 255, 256, 257, 497, 4096, 4111, 65535}) {
    const Bytes iv = random.bytes(BLOCK);
    const Bytes plaintext = random.bytes(length);
    expectBothWays(cipher, iv, plaintext, encrypted(cipher, iv, plaintext));
  }
}

TEST(Cfb128, writes_nothing_behind_the_message) {
  RandomBytes random(9);
  const Aes128 cipher(random.bytes(BLOCK).data());
  const Bytes iv = random.bytes(BLOCK);
  for (size_t length = 0; length <= 64; length++) {
    Bytes bytes(length + BLOCK, 0xAA);
    Cfb128(cipher, iv.data()).encrypt(bytes.data(), static_cast<uint16_t>(length));
    EXPECT_EQ(Bytes(BLOCK, 0xAA), Bytes(bytes.end() - BLOCK, bytes.end())) << length;
    Cfb128(cipher, iv.data()).decrypt(bytes.data(), static_cast<uint16_t>(length));
    EXPECT_EQ(Bytes(length + BLOCK, 0xAA), bytes) << length;
  }
}
