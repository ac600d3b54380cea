#include "Cfb128.h"

#include "../support/Wipe.h"

namespace javinolib {

namespace {

const uint8_t BLOCK = Aes128::BLOCK_LENGTH;

uint16_t wholeBlocks(uint16_t length) { return length & ~(BLOCK - 1); }
bool hasRest(uint16_t length) { return length % BLOCK != 0; }

}  // namespace

void Cfb128::encrypt(uint8_t *bytes, uint16_t length) const {
  uint8_t *const whole = bytes + wholeBlocks(length);
  if (whole != bytes) cipher_.chainUp(iv_, bytes, whole);
  if (hasRest(length)) applyToRest(bytes, length);
}

// From the end to the beginning, so that the ciphertext before each block is still there.
void Cfb128::decrypt(uint8_t *bytes, uint16_t length) const {
  if (hasRest(length)) applyToRest(bytes, length);
  uint8_t *const whole = bytes + wholeBlocks(length);
  if (whole == bytes) return;
  if (whole != bytes + BLOCK) cipher_.chainDown(bytes, whole);
  cipher_.chainUp(iv_, bytes, bytes + BLOCK);
}

// Encrypts or decrypts the bytes behind the whole blocks, which are ciphertext at this time.
void Cfb128::applyToRest(uint8_t *bytes, uint16_t length) const {
  const uint8_t rest = length % BLOCK;
  uint8_t *byte = bytes + wholeBlocks(length);
  uint8_t keyStream[BLOCK];
  cipher_.encrypt(byte == bytes ? iv_ : byte - BLOCK, keyStream);
  for (uint8_t i = 0; i < rest; i++) *byte++ ^= keyStream[i];
  wipe(keyStream, sizeof keyStream);
}

}  // namespace javinolib
