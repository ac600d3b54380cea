#include "Aes128Core.h"

#if !JAVINO_AES_IN_ASSEMBLY

#include <string.h>

#include "../support/Flash.h"
#include "../support/Wipe.h"

namespace {

using javino::flashByte;
using javino::wipe;

const uint8_t BLOCK_LENGTH = 16;
const uint8_t KEY_LENGTH = 16;
const uint8_t ROUNDS = 10;
const uint8_t ROUND_KEYS_LENGTH = (ROUNDS + 1) * BLOCK_LENGTH;

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

// Encrypts in place.
void encryptBlock(const uint8_t *roundKey, uint8_t *block) {
  addRoundKey(block, roundKey);
  for (uint8_t round = 1; round < ROUNDS; round++) {
    substituteAndShift(block);
    for (uint8_t column = 0; column < 4; column++) mixColumn(block + 4 * column);
    addRoundKey(block, roundKey += BLOCK_LENGTH);
  }
  substituteAndShift(block);
  addRoundKey(block, roundKey + BLOCK_LENGTH);
}

}  // namespace

void javino_aes128_expand(uint8_t *roundKeys, const uint8_t *key) {
  memcpy(roundKeys, key, KEY_LENGTH);
  uint8_t roundConstant = 1;
  for (uint8_t *word = roundKeys + KEY_LENGTH; word != roundKeys + ROUND_KEYS_LENGTH; word += 4) {
    const uint8_t *previous = word - 4;
    const uint8_t *above = word - KEY_LENGTH;
    if ((word - roundKeys) % KEY_LENGTH == 0) {
      word[0] = static_cast<uint8_t>(above[0] ^ substitute(previous[1]) ^ roundConstant);
      word[1] = above[1] ^ substitute(previous[2]);
      word[2] = above[2] ^ substitute(previous[3]);
      word[3] = above[3] ^ substitute(previous[0]);
      roundConstant = timesX(roundConstant);
    } else {
      for (uint8_t i = 0; i < 4; i++) word[i] = above[i] ^ previous[i];
    }
  }
}

void javino_aes128_encrypt(const uint8_t *roundKeys, const uint8_t *in, uint8_t *out) {
  memmove(out, in, BLOCK_LENGTH);
  encryptBlock(roundKeys, out);
}

void javino_aes128_chain(const uint8_t *roundKeys, const uint8_t *in, uint8_t *onto, const uint8_t *stop,
                         uint8_t back) {
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
