#include "Cfb128.h"

#include <string.h>

#include "../support/Wipe.h"

namespace javino {

Cfb128::Cfb128(const Aes128 &cipher, const uint8_t *iv) : cipher_(cipher), used_(Aes128::BLOCK_LENGTH) {
  memcpy(block_, iv, sizeof block_);
}

Cfb128::~Cfb128() { wipe(block_, sizeof block_); }

void Cfb128::apply(uint8_t *bytes, uint16_t length, bool decrypting) {
  const uint8_t *const end = bytes + length;
  // Within a block that an earlier call began, there are no whole ones.
  uint8_t *const whole = used_ == Aes128::BLOCK_LENGTH ? bytes + (length & ~(Aes128::BLOCK_LENGTH - 1)) : bytes;
  if (bytes != whole) {
    if (decrypting) {
      decryptBlocks(bytes, whole);
    } else {
      encryptBlocks(bytes, whole);
    }
  }
  for (bytes = whole; bytes != end; bytes++) {
    uint8_t *place = keyStreamByte();
    const uint8_t before = *bytes;
    *bytes ^= *place;
    *place = decrypting ? before : *bytes;
  }
}

// Whole blocks need no copy of the ciphertext: the block before is where it was encrypted.
void Cfb128::encryptBlocks(uint8_t *bytes, const uint8_t *end) {
  const uint8_t *previous = block_;
  do {
    cipher_.encryptOnto(previous, bytes);
    previous = bytes;
    bytes += Aes128::BLOCK_LENGTH;
  } while (bytes != end);
  memcpy(block_, previous, sizeof block_);
}

// From the last block to the first, so that the ciphertext before is still there.
void Cfb128::decryptBlocks(uint8_t *bytes, uint8_t *end) {
  uint8_t *block = end - Aes128::BLOCK_LENGTH;
  uint8_t last[Aes128::BLOCK_LENGTH];
  memcpy(last, block, sizeof last);
  for (; block != bytes; block -= Aes128::BLOCK_LENGTH) cipher_.encryptOnto(block - Aes128::BLOCK_LENGTH, block);
  cipher_.encryptOnto(block_, bytes);
  memcpy(block_, last, sizeof block_);
}

// The place of the next key stream byte, which the ciphertext byte takes afterwards: it feeds the next block.
uint8_t *Cfb128::keyStreamByte() {
  if (used_ == Aes128::BLOCK_LENGTH) {
    cipher_.encrypt(block_);
    used_ = 0;
  }
  return block_ + used_++;
}

}  // namespace javino
