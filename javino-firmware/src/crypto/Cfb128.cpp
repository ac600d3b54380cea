#include "Cfb128.h"

#include <string.h>

#include "../support/Wipe.h"

namespace javino {

Cfb128::Cfb128(const Aes128 &cipher, const uint8_t *iv) : cipher_(cipher), used_(Aes128::BLOCK_LENGTH) {
  memcpy(block_, iv, sizeof block_);
}

Cfb128::~Cfb128() { wipe(block_, sizeof block_); }

void Cfb128::encrypt(uint8_t *bytes, uint16_t length) {
  for (uint16_t i = 0; i < length; i++) {
    uint8_t *place = keyStreamByte();
    bytes[i] ^= *place;
    *place = bytes[i];
  }
}

void Cfb128::decrypt(uint8_t *bytes, uint16_t length) {
  for (uint16_t i = 0; i < length; i++) {
    uint8_t *place = keyStreamByte();
    const uint8_t ciphertext = bytes[i];
    bytes[i] ^= *place;
    *place = ciphertext;
  }
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
