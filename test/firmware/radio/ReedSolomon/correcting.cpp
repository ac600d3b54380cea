#include <gtest/gtest.h>

#include "Codeword.h"
#include "support/Vectors.h"

TEST(ReedSolomon, correctsTheVectors) {
  for (const DamagedVector &vector : damagedVectors()) {
    Bytes codeword = vector.received;
    EXPECT_EQ(mend(codeword, vector.erasures), Progress::CORRECTED);
    EXPECT_EQ(codeword, vector.codeword);
  }
}

TEST(ReedSolomon, leavesACodewordAsItIs) {
  std::mt19937 random(3);
  for (size_t length = 1; length <= 80; length++) {
    const Bytes whole = withParity(randomBytes(length, random));
    for (size_t erasures : {0, 1, 16}) {
      Bytes codeword = whole;
      EXPECT_EQ(mend(codeword, somePositions(whole.size(), erasures, random)), Progress::CORRECTED);
      EXPECT_EQ(codeword, whole);
    }
  }
}

// 2 e + f <= 16, each pair, the shortest to the longest packet.
TEST(ReedSolomon, correctsAsManyErrorsAndErasuresAsItsParityAllows) {
  std::mt19937 random(4);
  for (size_t erasures = 0; erasures <= PARITY_LENGTH; erasures++) {
    for (size_t errors = 0; 2 * errors + erasures <= PARITY_LENGTH; errors++) {
      for (size_t length : {1, 4, 20, 79, 80, 239}) {
        if (errors + erasures > length + PARITY_LENGTH) continue;
        const Bytes whole = withParity(randomBytes(length, random));
        const Bytes wrong = somePositions(whole.size(), errors + erasures, random);
        Bytes codeword = damagedAt(whole, wrong, random);
        const Bytes erased(wrong.begin(), wrong.begin() + static_cast<long>(erasures));
        ASSERT_EQ(mend(codeword, erased), Progress::CORRECTED) << errors << " errors, " << erasures << " erasures";
        ASSERT_EQ(codeword, whole) << errors << " errors, " << erasures << " erasures";
      }
    }
  }
}

// Not a byte was wrong where a symbol was none.
TEST(ReedSolomon, takesErasuresThatAreRight) {
  std::mt19937 random(5);
  for (int i = 0; i < 300; i++) {
    const Bytes whole = withParity(randomBytes(40, random));
    const Bytes places = somePositions(whole.size(), 12, random);
    Bytes codeword = damagedAt(whole, Bytes(places.begin() + 6, places.end()), random);
    ASSERT_EQ(mend(codeword, Bytes(places.begin(), places.begin() + 8)), Progress::CORRECTED);  // 2 erased, 4 not
    ASSERT_EQ(codeword, whole);
  }
}

TEST(ReedSolomon, correctsABurstOf16BytesAnywhereThatIsErased) {
  std::mt19937 random(6);
  const Bytes whole = withParity(randomBytes(80, random));
  for (size_t first = 0; first + PARITY_LENGTH <= whole.size(); first++) {
    Bytes burst(PARITY_LENGTH);
    for (uint8_t i = 0; i < PARITY_LENGTH; i++) burst[i] = static_cast<uint8_t>(first + i);
    Bytes codeword = damagedAt(whole, burst, random);
    ASSERT_EQ(mend(codeword, burst), Progress::CORRECTED) << first;
    ASSERT_EQ(codeword, whole) << first;
  }
}

TEST(ReedSolomon, countsAnErasureThatIsNamedTwiceOnce) {
  std::mt19937 random(7);
  const Bytes whole = withParity(randomBytes(30, random));
  const Bytes erased = somePositions(whole.size(), PARITY_LENGTH, random);
  Bytes named = erased;
  named.insert(named.end(), erased.begin(), erased.end());
  Bytes codeword = damagedAt(whole, erased, random);
  EXPECT_EQ(mend(codeword, named), Progress::CORRECTED);
  EXPECT_EQ(codeword, whole);
}

TEST(ReedSolomon, ignoresAnErasureBehindTheEnd) {
  std::mt19937 random(8);
  const Bytes whole = withParity(randomBytes(30, random));
  Bytes codeword = damagedAt(whole, somePositions(whole.size(), 8, random), random);
  EXPECT_EQ(mend(codeword, {46, 47, 96, 254, 255}), Progress::CORRECTED);
  EXPECT_EQ(codeword, whole);
}

TEST(ReedSolomon, beginsAnewAtAnyStep) {
  std::mt19937 random(9);
  for (int steps = 0; steps < MOST_STEPS / 2; steps++) {
    javinolib::reedsolomon::Decoder decoder;
    Bytes other = randomBytes(96, random);
    decoder.begin(other.data(), 96);
    decoder.erase(3);
    for (int i = 0; i < steps; i++) decoder.step();
    const Bytes whole = withParity(randomBytes(30, random));
    Bytes codeword = damagedAt(whole, somePositions(whole.size(), 8, random), random);
    decoder.begin(codeword.data(), static_cast<uint8_t>(codeword.size()));
    EXPECT_EQ(finish(decoder), Progress::CORRECTED);
    EXPECT_EQ(codeword, whole);
  }
}
