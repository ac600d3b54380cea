// The results of the assembly: the same vectors that the portable code and the Java library are held to.
#include "../firmware/support/Reference.h"
#include "../firmware/support/Vectors.h"
#include "../firmware/support/Wycheproof.h"

#include <gtest/gtest.h>

#include "TestMega.h"

namespace {

const size_t HEADER_LENGTH = 10;

// Address and size digits as in SPEC 1 and 2; the vector has no plain frame.
Bytes plainFrame(const Vector &vector) {
  return reference::frame(vector.text("destination"), vector.text("origin"), vector.bytes("content"));
}

}  // namespace

TEST(Vectors, aes_of_nist) {
  for (const Vector &vector : vectors("nist.json", "aes")) {
    const Outcome outcome = perform(Mailbox::ENCRYPT_BLOCK, vector.bytes("key"), {}, vector.bytes("plaintext"));
    EXPECT_EQ(vector.text("ciphertext"), toHex(outcome.bytes(16))) << vector.toString();
  }
}

TEST(Vectors, cfb128_of_nist) {
  for (const Vector &vector : vectors("nist.json", "cfb128")) {
    const Bytes plaintext = vector.bytes("plaintext");
    const Bytes ciphertext = vector.bytes("ciphertext");
    const Bytes key = vector.bytes("key");
    const Bytes iv = vector.bytes("iv");
    for (size_t length = 0; length <= plaintext.size(); length++) {
      const Bytes some(plaintext.begin(), plaintext.begin() + static_cast<long>(length));
      const Bytes same(ciphertext.begin(), ciphertext.begin() + static_cast<long>(length));
      EXPECT_EQ(toHex(same), toHex(perform(Mailbox::ENCRYPT_CFB, key, iv, some).bytes(length)));
      EXPECT_EQ(toHex(some), toHex(perform(Mailbox::DECRYPT_CFB, key, iv, same).bytes(length)));
    }
  }
}

TEST(Vectors, cmac_of_nist) {
  for (const Vector &vector : vectors("nist.json", "cmac")) {
    const Outcome outcome = perform(Mailbox::COMPUTE_CMAC, vector.bytes("key"), {}, vector.bytes("message"));
    EXPECT_EQ(vector.text("tag"), toHex(outcome.bytes(16))) << vector.toString();
  }
}

TEST(Wycheproof, cmac) {
  EXPECT_EQ("", wronglyJudgedCmacs("`Cmac` on an emulated Mega", [](const Bytes &key, const Bytes &message) {
              return perform(Mailbox::COMPUTE_CMAC, key, {}, message).bytes(16);
            }));
}

TEST(Vectors, derived_keys) {
  for (const Vector &vector : vectors("keys.json", "derivations")) {
    const Outcome outcome = perform(Mailbox::DERIVE_KEYS, vector.bytes("key"), {}, {});
    EXPECT_EQ(vector.text("kenc") + vector.text("kmac") + vector.text("check"), toHex(outcome.bytes(35)));
  }
}

#ifndef JAVINO_SMALL
TEST(Vectors, parities) {
  for (const Vector &vector : vectors("parity.json", "parities")) {
    const Outcome outcome = perform(Mailbox::ADD_PARITY, {}, {}, vector.bytes("bytes"));
    EXPECT_EQ(vector.text("parity"), toHex(outcome.bytes(16))) << vector.toString();
  }
}
#endif

TEST(Vectors, sealed_frames) {
  for (const Vector &vector : vectors("envelopes.json", "valid")) {
    const Bytes kenc = vector.bytes("kenc");
    const Bytes kmac = vector.bytes("kmac");
    const Bytes sealed = vector.bytes("frame");
#ifdef JAVINO_SMALL
    if (sealed.size() > 255) continue;  // longer than any frame of a small board
#endif
    const Outcome sealing = perform(Mailbox::SEAL, kenc, kmac, plainFrame(vector), vector.bytes("nonce"));
    ASSERT_EQ(sealed.size(), sealing.mailbox.length) << vector.toString();
    EXPECT_EQ(toHex(sealed), toHex(sealing.bytes(sealed.size()))) << vector.toString();

    const Outcome opening = perform(Mailbox::OPEN, kenc, kmac, sealed);
    const Bytes content = vector.bytes("content");
    ASSERT_EQ(content.size(), opening.mailbox.length) << vector.toString();
    const Bytes opened = opening.bytes(sealed.size());
    const auto begin = opened.begin() + static_cast<long>(HEADER_LENGTH + 6);
    EXPECT_EQ(toHex(content), toHex(Bytes(begin, begin + static_cast<long>(content.size())))) << vector.toString();
  }
}

TEST(Vectors, forged_frames) {
  const Vector valid = vectors("envelopes.json", "valid").front();
  const Bytes sealed = valid.bytes("frame");
  for (size_t i = 0; i < sealed.size(); i++) {
    Bytes forged = sealed;
    forged[i] ^= static_cast<uint8_t>(1 << i % 8);
    EXPECT_EQ(0xFFFF, perform(Mailbox::OPEN, valid.bytes("kenc"), valid.bytes("kmac"), forged).mailbox.length) << i;
  }
}
