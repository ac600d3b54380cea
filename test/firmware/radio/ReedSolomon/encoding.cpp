#include <gtest/gtest.h>

#include "Codeword.h"
#include "support/Vectors.h"

TEST(ReedSolomon, givesTheParityOfTheVectors) {
  for (const ParityVector &vector : parityVectors()) {
    const Bytes codeword = withParity(vector.bytes);
    EXPECT_EQ(Bytes(codeword.end() - PARITY_LENGTH, codeword.end()), vector.parity);
  }
}

TEST(ReedSolomon, givesACodewordForEachLength) {
  std::mt19937 random(1);
  for (size_t length = 1; length <= 239; length++) EXPECT_TRUE(isCodeword(withParity(randomBytes(length, random))));
}

TEST(ReedSolomon, readsAndWritesNothingElse) {
  std::mt19937 random(2);
  Bytes memory = randomBytes(80 + PARITY_LENGTH + 2, random);
  const Bytes before = memory;
  javinolib::reedsolomon::encode(memory.data() + 1, 80, memory.data() + 81);
  EXPECT_EQ(Bytes(before.begin(), before.begin() + 81), Bytes(memory.begin(), memory.begin() + 81));
  EXPECT_EQ(before.back(), memory.back());
}
