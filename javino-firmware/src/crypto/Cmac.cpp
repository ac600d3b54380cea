#include "Cmac.h"

#include <string.h>

#include "../support/Wipe.h"

namespace javinolib {

namespace {

const uint8_t BLOCK = Aes128::BLOCK_LENGTH;

// Shifts 16 bytes left by one bit and folds the lost bit back in, without a branch on it: the step from one subkey
// to the next (SP 800-38B section 6.1).
void doubleInField(uint8_t *block) {
  const uint8_t overflow = static_cast<uint8_t>(-(block[0] >> 7));
  uint8_t carry = overflow & 0x87;
  for (uint8_t *byte = block + BLOCK; byte-- != block;) {
    const uint8_t before = *byte;
    *byte = static_cast<uint8_t>(before << 1) ^ carry;
    carry = before >> 7;
  }
}

// The length is one byte at least.
void xorInto(uint8_t *into, const uint8_t *from, uint8_t length) {
  do {
    *into++ ^= *from++;
  } while (--length != 0);
}

// Computes the first subkey, K1.
JAVINO_NOINLINE void firstSubkey(const Aes128 &cipher, uint8_t *block) {
  memset(block, 0, BLOCK);
  cipher.encrypt(block);
  doubleInField(block);
}

// A subkey that is not given is computed in the place of the last block: 18 bytes of the stack less than a Cmac.
JAVINO_NOINLINE void computeTag(const Aes128 &cipher, const uint8_t *subkey, const uint8_t *message, uint16_t length,
                                uint8_t *tag) {
  // Becomes the last block: its subkey, its bytes, and what comes from the blocks before, added up.
  uint8_t last[BLOCK];
  if (subkey == nullptr) {
    firstSubkey(cipher, last);
  } else {
    memcpy(last, subkey, BLOCK);
  }
  const uint8_t lastLength = length > 0 && length % BLOCK == 0 ? BLOCK : static_cast<uint8_t>(length % BLOCK);
  if (lastLength < BLOCK) {
    doubleInField(last);
    last[lastLength] ^= 0x80;
  }
  const uint8_t *const lastBytes = message + (length - lastLength);
  if (lastLength != 0) xorInto(last, lastBytes, lastLength);

  if (message != lastBytes) {
    cipher.encrypt(message, tag);
    while ((message += BLOCK) != lastBytes) {
      xorInto(tag, message, BLOCK);
      cipher.encrypt(tag);
    }
    xorInto(last, tag, BLOCK);
  }
  cipher.encrypt(last, tag);
  wipe(last, sizeof last);
}

}  // namespace

Cmac::Cmac(const Aes128 &cipher) : cipher_(cipher) { firstSubkey(cipher, subkey_); }

Cmac::~Cmac() { wipe(subkey_, sizeof subkey_); }

void Cmac::compute(const uint8_t *message, uint16_t length, uint8_t *tag) const {
  computeTag(cipher_, subkey_, message, length, tag);
}

void cmac(const Aes128 &cipher, const uint8_t *message, uint16_t length, uint8_t *tag) {
  computeTag(cipher, nullptr, message, length, tag);
}

bool equalInConstantTime(const uint8_t *some, const uint8_t *other, uint8_t length) {
  uint8_t difference = 0;
  for (uint8_t i = 0; i < length; i++) difference |= some[i] ^ other[i];
  return difference == 0;
}

}  // namespace javinolib
