#include "Cfb128.h"

#include <string.h>

#include "../support/Wipe.h"

namespace javinolib {

static const uint8_t BLOCK = Aes128::BLOCK_LENGTH;

#if JAVINO_LARGE

void Cfb128::apply(const Aes128 &cipher, const uint8_t *iv, uint8_t *bytes, uint16_t length, bool decrypting) {
  const uint8_t restLength = length % BLOCK;
  uint8_t *const rest = bytes + (length - restLength);
  if (decrypting && restLength != 0) applyToRest(cipher, rest == bytes ? iv : rest - BLOCK, rest, restLength);
  if (rest != bytes) {
    uint8_t *end = rest;
    if (decrypting) {  // from the end to the beginning, so that the ciphertext before each block is still there
      end = bytes + BLOCK;
      if (rest != end) cipher.chainDown(bytes, rest);
    }
    cipher.chainUp(iv, bytes, end);
  }
  if (!decrypting && restLength != 0) applyToRest(cipher, rest == bytes ? iv : rest - BLOCK, rest, restLength);
}

// Encrypts or decrypts the bytes behind the whole blocks.
// @param before the 16 bytes of ciphertext before them
void Cfb128::applyToRest(const Aes128 &cipher, const uint8_t *before, uint8_t *rest, uint8_t length) {
  uint8_t keyStream[BLOCK];
  cipher.encrypt(before, keyStream);
  for (uint8_t i = 0; i < length; i++) rest[i] ^= keyStream[i];
  wipe(keyStream, sizeof keyStream);
}

#else

// Byte by byte: the ciphertext takes the place of the key stream, and is what is encrypted next.
void Cfb128::apply(const Aes128 &cipher, const uint8_t *iv, uint8_t *bytes, uint16_t length, bool decrypting) {
  uint8_t stream[BLOCK];
  memcpy(stream, iv, BLOCK);
  uint8_t at = BLOCK;
  for (; length != 0; length--) {
    if (at == BLOCK) {
      cipher.encrypt(stream);
      at = 0;
    }
    const uint8_t before = *bytes;
    const uint8_t after = static_cast<uint8_t>(before ^ stream[at]);
    stream[at++] = decrypting ? before : after;
    *bytes++ = after;
  }
  wipe(stream, sizeof stream);
}

#endif

}  // namespace javinolib
