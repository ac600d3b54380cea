#include <crypto/Cfb128.h>
#include <gtest/gtest.h>

#include "support/Vectors.h"

using javinolib::Aes128;
using javinolib::Cfb128;

TEST(Cfb128, encrypts_all_vectors_of_SP_800_38A) {
  for (const Vector &vector : vectors("nist.json", "cfb128")) {
    SCOPED_TRACE(vector.toString());
    const Aes128 cipher(vector.bytes("key").data());
    Bytes bytes = vector.bytes("plaintext");
    Cfb128(cipher, vector.bytes("iv").data()).encrypt(bytes.data(), static_cast<uint16_t>(bytes.size()));
    EXPECT_EQ(vector.text("ciphertext"), toHex(bytes));
  }
}

TEST(Cfb128, decrypts_all_vectors_of_SP_800_38A) {
  for (const Vector &vector : vectors("nist.json", "cfb128")) {
    SCOPED_TRACE(vector.toString());
    const Aes128 cipher(vector.bytes("key").data());
    Bytes bytes = vector.bytes("ciphertext");
    Cfb128(cipher, vector.bytes("iv").data()).decrypt(bytes.data(), static_cast<uint16_t>(bytes.size()));
    EXPECT_EQ(vector.text("plaintext"), toHex(bytes));
  }
}
