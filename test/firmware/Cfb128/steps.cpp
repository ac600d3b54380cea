#include <crypto/Cfb128.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/Vectors.h"

using javino::Aes128;
using javino::Cfb128;

namespace {

Vector longest() {
  const std::vector<Vector> all = vectors("nist.json", "cfb128");
  return *std::max_element(all.begin(), all.end(), [](const Vector &some, const Vector &other) {
    return some.text("plaintext").size() < other.text("plaintext").size();
  });
}

typedef void (Cfb128::*Direction)(uint8_t *, uint16_t);

Bytes inSteps(Direction direction, const Vector &vector, Bytes bytes, size_t step) {
  const Aes128 cipher(vector.bytes("key").data());
  Cfb128 mode(cipher, vector.bytes("iv").data());
  for (size_t at = 0; at < bytes.size(); at += step) {
    (mode.*direction)(bytes.data() + at, static_cast<uint16_t>(std::min(step, bytes.size() - at)));
  }
  return bytes;
}

}  // namespace

// SP 800-38A F.3.13 and F.3.14 in steps of every size, odd ones included.
TEST(Cfb128, every_step_size_gives_the_same_bytes) {
  const Vector vector = longest();
  for (size_t step = 1; step <= vector.bytes("plaintext").size(); step++) {
    EXPECT_EQ(vector.bytes("ciphertext"), inSteps(&Cfb128::encrypt, vector, vector.bytes("plaintext"), step));
    EXPECT_EQ(vector.bytes("plaintext"), inSteps(&Cfb128::decrypt, vector, vector.bytes("ciphertext"), step));
  }
}

// SP 800-38A section 5.2 wants whole segments; a short last one is the beginning of a whole one.
TEST(Cfb128, a_short_last_block_is_the_beginning_of_a_whole_one) {
  const Vector vector = longest();
  const Bytes plaintext = vector.bytes("plaintext");
  const Bytes ciphertext = vector.bytes("ciphertext");
  for (size_t length = 0; length <= plaintext.size(); length++) {
    const Bytes part(plaintext.begin(), plaintext.begin() + length);
    EXPECT_EQ(Bytes(ciphertext.begin(), ciphertext.begin() + length),
              inSteps(&Cfb128::encrypt, vector, part, part.size() + 1));
  }
}
