#include <gtest/gtest.h>

#include "Codeword.h"

namespace {

size_t differences(const Bytes &a, const Bytes &b) {
  size_t count = 0;
  for (size_t i = 0; i < a.size(); i++) count += a[i] != b[i];
  return count;
}

bool contains(const Bytes &bytes, uint8_t byte) { return std::find(bytes.begin(), bytes.end(), byte) != bytes.end(); }

// Whatever came: either nothing was changed, or a codeword is there now that this many errors and erasures lead to.
void check(const Bytes &received, const Bytes &erasures, Progress *result = nullptr) {
  Bytes codeword = received;
  const Progress progress = mend(codeword, erasures);
  if (result != nullptr) *result = progress;
  ASSERT_NE(progress, Progress::PENDING);
  if (progress == Progress::FAILED) {
    ASSERT_EQ(codeword, received);
    return;
  }
  ASSERT_TRUE(isCodeword(codeword));
  size_t errors = 0;
  for (size_t i = 0; i < received.size(); i++)
    errors += received[i] != codeword[i] && !contains(erasures, static_cast<uint8_t>(i));
  ASSERT_LE(2 * errors + erasures.size(), size_t(PARITY_LENGTH));
}

}  // namespace

TEST(ReedSolomon, failsWithoutAChangeOrFindsAnotherCodewordNearby) {
  std::mt19937 random(10);
  for (int i = 0; i < 20000; i++) {
    const Bytes whole = withParity(randomBytes(1 + random() % 80, random));
    const size_t erasures = random() % (PARITY_LENGTH + 1);
    const size_t errors = std::min(random() % 20, whole.size() - erasures);
    const Bytes wrong = somePositions(whole.size(), erasures + errors, random);
    check(damagedAt(whole, wrong, random), Bytes(wrong.begin(), wrong.begin() + static_cast<long>(erasures)));
    if (HasFatalFailure()) return;
  }
}

// Among all words, one in 8! lies within 8 bytes of a codeword (McEliece and Swanson, 1986).
TEST(ReedSolomon, failsWithoutErasuresOnRandomBytes) {
  std::mt19937 random(11);
  for (int i = 0; i < 3000; i++) {
    Progress progress;
    check(randomBytes(17 + random() % 80, random), {}, &progress);
    if (HasFatalFailure()) return;
    EXPECT_EQ(progress, Progress::FAILED);
  }
}

// Nine wrong bytes are more than can be found, and another codeword is rarely as near.
TEST(ReedSolomon, failsAtNineErrors) {
  std::mt19937 random(12);
  for (int i = 0; i < 1000; i++) {
    const Bytes whole = withParity(randomBytes(80, random));
    const Bytes received = damagedAt(whole, somePositions(whole.size(), 9, random), random);
    Progress progress;
    check(received, {}, &progress);
    if (HasFatalFailure()) return;
    EXPECT_EQ(progress, Progress::FAILED);
    EXPECT_EQ(differences(received, whole), 9u);
  }
}

TEST(ReedSolomon, failsAtMoreErasuresThanParity) {
  std::mt19937 random(13);
  for (size_t count : {17, 18, 40, 96}) {
    Bytes codeword = withParity(randomBytes(80, random));
    const Bytes erasures = somePositions(codeword.size(), count, random);
    EXPECT_EQ(mend(codeword, erasures), Progress::FAILED) << count;
  }
}

TEST(ReedSolomon, failsAtLengthsThatHoldNoData) {
  for (uint8_t length = 0; length <= PARITY_LENGTH; length++) {
    Bytes codeword(length);
    EXPECT_EQ(mend(codeword, {0, 3}), Progress::FAILED) << int(length);
  }
}

// Any calls in any order: nothing outside of codeword and decoder is touched (the sanitizers look), and each end stays.
TEST(ReedSolomon, bearsAnyCalls) {
  std::mt19937 random(14);
  for (int i = 0; i < 5000; i++) {
    Bytes codeword = randomBytes(random() % 256, random);
    if (random() % 2) codeword = Bytes(codeword.size(), 0);
    javinolib::reedsolomon::Decoder decoder;
    decoder.begin(codeword.data(), static_cast<uint8_t>(codeword.size()));
    for (int calls = static_cast<int>(random() % 60); calls > 0; calls--) {
      if (random() % 2) {
        decoder.erase(static_cast<uint8_t>(random()));
      } else {
        decoder.step();
      }
    }
    const Progress progress = finish(decoder);
    EXPECT_NE(progress, Progress::PENDING);
    const Bytes then = codeword;
    EXPECT_EQ(decoder.step(), progress);
    EXPECT_EQ(codeword, then);
  }
}
