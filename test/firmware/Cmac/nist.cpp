#include <crypto/Cmac.h>
#include <gtest/gtest.h>

#include "support/Vectors.h"

TEST(Cmac, tags_all_vectors_of_SP_800_38B) {
  for (const Vector &vector : vectors("nist.json", "cmac")) {
    SCOPED_TRACE(vector.toString());
    const javinolib::Aes128 cipher(vector.bytes("key").data());
    const Bytes message = vector.bytes("message");
    Bytes tag(16);
    javinolib::cmac(cipher, message.data(), static_cast<uint16_t>(message.size()), tag.data());
    EXPECT_EQ(vector.text("tag"), toHex(tag));
  }
}

TEST(Cmac, comparison_sees_a_difference_in_every_bit) {
  const Bytes some(8, 0xA5);
  EXPECT_TRUE(javinolib::equalInConstantTime(some.data(), some.data(), 8));
  for (int bit = 0; bit < 64; bit++) {
    Bytes other = some;
    other[bit / 8] = static_cast<uint8_t>(other[bit / 8] ^ 1 << bit % 8);
    EXPECT_FALSE(javinolib::equalInConstantTime(some.data(), other.data(), 8)) << bit;
  }
}
