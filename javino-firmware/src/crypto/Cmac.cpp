#include "Cmac.h"

#include <string.h>

#include "../support/Wipe.h"

namespace javino {

namespace {

const uint8_t BLOCK = Aes128::BLOCK_LENGTH;

// Shifts 16 bytes left by one bit and folds the lost bit back in, without a branch on it: the step from one subkey
// to the next (SP 800-38B section 6.1).
void doubleInField(uint8_t *block) {
  const uint8_t overflow = static_cast<uint8_t>(-(block[0] >> 7));
  for (uint8_t i = 0; i < BLOCK - 1; i++) block[i] = static_cast<uint8_t>(block[i] << 1 | block[i + 1] >> 7);
  block[BLOCK - 1] = static_cast<uint8_t>(block[BLOCK - 1] << 1 ^ (overflow & 0x87));
}

void xorInto(uint8_t *into, const uint8_t *from, uint16_t length) {
  for (uint16_t i = 0; i < length; i++) into[i] ^= from[i];
}

}  // namespace

void cmac(const Aes128 &cipher, const uint8_t *message, uint16_t length, uint8_t *tag) {
  uint8_t subkey[BLOCK];
  memset(subkey, 0, BLOCK);
  cipher.encrypt(subkey);
  doubleInField(subkey);

  memset(tag, 0, BLOCK);
  for (; length > BLOCK; message += BLOCK, length = static_cast<uint16_t>(length - BLOCK)) {
    xorInto(tag, message, BLOCK);
    cipher.encrypt(tag);
  }
  xorInto(tag, message, length);
  if (length < BLOCK) {
    tag[length] ^= 0x80;
    doubleInField(subkey);
  }
  xorInto(tag, subkey, BLOCK);
  cipher.encrypt(tag);
  wipe(subkey, sizeof subkey);
}

bool equalInConstantTime(const uint8_t *some, const uint8_t *other, uint8_t length) {
  uint8_t difference = 0;
  for (uint8_t i = 0; i < length; i++) difference |= some[i] ^ other[i];
  return difference == 0;
}

}  // namespace javino
