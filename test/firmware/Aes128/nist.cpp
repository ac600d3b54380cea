#include <crypto/Aes128.h>
#include <gtest/gtest.h>

#include "support/Vectors.h"

using javinolib::Aes128;

TEST(Aes128, encrypts_all_vectors_of_FIPS_197_and_SP_800_38A) {
  for (const Vector &vector : vectors("nist.json", "aes")) {
    SCOPED_TRACE(vector.toString());
    const Aes128 cipher(vector.bytes("key").data());
    Bytes block = vector.bytes("plaintext");
    cipher.encrypt(block.data());
    EXPECT_EQ(vector.text("ciphertext"), toHex(block));
  }
}

TEST(Aes128, a_key_can_be_replaced) {
  const Vector first = vectors("nist.json", "aes").front();
  Aes128 cipher(Bytes(16, 0x5A).data());
  cipher.setKey(first.bytes("key").data());
  Bytes block = first.bytes("plaintext");
  cipher.encrypt(block.data());
  EXPECT_EQ(first.text("ciphertext"), toHex(block));
}

TEST(Aes128, every_bit_of_key_and_block_matters) {
  const Bytes key(16, 0x11);
  Bytes reference(16, 0x22);
  Aes128(key.data()).encrypt(reference.data());
  for (int bit = 0; bit < 128; bit++) {
    Bytes otherKey = key;
    otherKey[bit / 8] = static_cast<uint8_t>(otherKey[bit / 8] ^ 1 << bit % 8);
    Bytes block(16, 0x22);
    Aes128(otherKey.data()).encrypt(block.data());
    EXPECT_NE(reference, block) << bit;

    Bytes otherBlock(16, 0x22);
    otherBlock[bit / 8] = static_cast<uint8_t>(otherBlock[bit / 8] ^ 1 << bit % 8);
    Aes128(key.data()).encrypt(otherBlock.data());
    EXPECT_NE(reference, otherBlock) << bit;
  }
}
