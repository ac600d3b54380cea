#include "Aes128Core.h"

#if !JAVINO_AES_IN_ASSEMBLY

#include <string.h>

#include "../support/Flash.h"
#include "../support/Wipe.h"

namespace {

using javinolib::flashByte;
using javinolib::wipe;

const uint8_t BLOCK_LENGTH = 16;
const uint8_t ROUNDS = 10;

const uint8_t S_BOX[256] JAVINO_FLASH = {
#define ROW(...) __VA_ARGS__,
#include "Aes128SBox.inc"
#undef ROW
};

inline uint8_t substitute(uint8_t byte) { return flashByte(S_BOX + byte); }

// Multiplies by x in GF(2^8), without a branch on the byte (FIPS 197 section 4.2.1).
inline uint8_t timesX(uint8_t byte) {
  const uint8_t overflow = static_cast<uint8_t>(-(byte >> 7));
  return static_cast<uint8_t>(byte << 1 ^ (overflow & 0x1b));
}

void addRoundKey(uint8_t *state, const uint8_t *roundKey) {
  for (uint8_t i = 0; i < BLOCK_LENGTH; i++) state[i] ^= roundKey[i];
}

// SubBytes and ShiftRows in one pass: row r of the state is every fourth byte from r on.
void substituteAndShift(uint8_t *state) {
  uint8_t from[BLOCK_LENGTH];
  memcpy(from, state, sizeof from);
  for (uint8_t i = 0; i < BLOCK_LENGTH; i++) {
    state[i] = substitute(from[(i + 4 * (i & 3)) & 15]);
  }
  wipe(from, sizeof from);
}

void mixColumn(uint8_t *column) {
  const uint8_t first = column[0];
  const uint8_t all = column[0] ^ column[1] ^ column[2] ^ column[3];
  for (uint8_t i = 0; i < 3; i++) {
    column[i] = static_cast<uint8_t>(column[i] ^ all ^ timesX(column[i] ^ column[i + 1]));
  }
  column[3] = static_cast<uint8_t>(column[3] ^ all ^ timesX(column[3] ^ first));
}

// Makes a round key the next one (FIPS 197 section 5.2).
void advance(uint8_t *roundKey, uint8_t &roundConstant) {
  const uint8_t *const last = roundKey + BLOCK_LENGTH - 4;
  for (uint8_t i = 0; i < 4; i++) roundKey[i] ^= substitute(last[(i + 1) & 3]);
  roundKey[0] ^= roundConstant;
  roundConstant = timesX(roundConstant);
  for (uint8_t i = 4; i < BLOCK_LENGTH; i++) roundKey[i] ^= roundKey[i - 4];
}

#if JAVINO_LARGE

// The round keys of a block, one after the other.
class Schedule {
 public:
  explicit Schedule(const uint8_t *roundKeys) : next_(roundKeys) {}

  const uint8_t *next() {
    next_ += BLOCK_LENGTH;
    return next_ - BLOCK_LENGTH;
  }

 private:
  const uint8_t *next_;
};

#else

class Schedule {
 public:
  explicit Schedule(uint8_t *roundKeys) : present_(roundKeys), roundConstant_(0) {}

  const uint8_t *next() {
    if (roundConstant_ == 0) {
      memcpy(present_, present_ + BLOCK_LENGTH, BLOCK_LENGTH);
      roundConstant_ = 1;
    } else {
      advance(present_, roundConstant_);
    }
    return present_;
  }

 private:
  uint8_t *const present_;
  uint8_t roundConstant_;
};

#endif

// Encrypts in place.
void encryptBlock(Schedule schedule, uint8_t *block) {
  addRoundKey(block, schedule.next());
  for (uint8_t round = 1; round < ROUNDS; round++) {
    substituteAndShift(block);
    for (uint8_t column = 0; column < 4; column++) mixColumn(block + 4 * column);
    addRoundKey(block, schedule.next());
  }
  substituteAndShift(block);
  addRoundKey(block, schedule.next());
}

}  // namespace

void javino_aes128_expand(uint8_t *roundKeys, const uint8_t *key) {
#if JAVINO_LARGE
  memcpy(roundKeys, key, BLOCK_LENGTH);
  uint8_t roundConstant = 1;
  for (uint8_t round = 0; round < ROUNDS; round++, roundKeys += BLOCK_LENGTH) {
    memcpy(roundKeys + BLOCK_LENGTH, roundKeys, BLOCK_LENGTH);
    advance(roundKeys + BLOCK_LENGTH, roundConstant);
  }
#else
  memcpy(roundKeys + BLOCK_LENGTH, key, BLOCK_LENGTH);
#endif
}

void javino_aes128_encrypt(uint8_t *roundKeys, const uint8_t *in, uint8_t *out) {
  memmove(out, in, BLOCK_LENGTH);
  encryptBlock(Schedule(roundKeys), out);
}

#if JAVINO_LARGE
void javino_aes128_chain(uint8_t *roundKeys, const uint8_t *in, uint8_t *onto, const uint8_t *stop, uint8_t back) {
  uint8_t block[BLOCK_LENGTH];
  do {
    javino_aes128_encrypt(roundKeys, in, block);
    for (uint8_t i = 0; i < BLOCK_LENGTH; i++) *onto++ ^= block[i];
    onto -= back;
    in = onto - BLOCK_LENGTH;
  } while (onto != stop);
  wipe(block, sizeof block);
}
#endif

#endif
