#include "Cfb128.h"

#include <string.h>

#include "../support/Wipe.h"

namespace javino {

Cfb128::Cfb128(const Aes128 &cipher, const uint8_t *iv) : cipher_(cipher), used_(Aes128::BLOCK_LENGTH) {
  memcpy(block_, iv, sizeof block_);
}

Cfb128::~Cfb128() { wipe(block_, sizeof block_); }

void Cfb128::apply(uint8_t *bytes, uint16_t length, bool decrypting) {
  for (const uint8_t *end = bytes + length; bytes != end;) {
    const uint16_t blocks = static_cast<uint16_t>(end - bytes) / Aes128::BLOCK_LENGTH;
    if (used_ == Aes128::BLOCK_LENGTH && blocks > 0) {
      bytes = decrypting ? decryptBlocks(bytes, blocks) : encryptBlocks(bytes, blocks);
    } else {
      uint8_t *place = keyStreamByte();
      const uint8_t before = *bytes;
      *bytes ^= *place;
      *place = decrypting ? before : *bytes;
      bytes++;
    }
  }
}

// Whole blocks need no copy of the ciphertext: the block before is where it was encrypted.
uint8_t *Cfb128::encryptBlocks(uint8_t *bytes, uint16_t blocks) {
  const uint8_t *previous = block_;
  for (; blocks > 0; blocks--, bytes += Aes128::BLOCK_LENGTH) {
    cipher_.encryptOnto(previous, bytes);
    previous = bytes;
  }
  memcpy(block_, previous, sizeof block_);
  return bytes;
}

// From the last block to the first, so that the ciphertext before is still there.
uint8_t *Cfb128::decryptBlocks(uint8_t *bytes, uint16_t blocks) {
  uint8_t *const end = bytes + blocks * Aes128::BLOCK_LENGTH;
  uint8_t *block = end - Aes128::BLOCK_LENGTH;
  uint8_t last[Aes128::BLOCK_LENGTH];
  memcpy(last, block, sizeof last);
  for (; block != bytes; block -= Aes128::BLOCK_LENGTH) cipher_.encryptOnto(block - Aes128::BLOCK_LENGTH, block);
  cipher_.encryptOnto(block_, bytes);
  memcpy(block_, last, sizeof block_);
  return end;
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
