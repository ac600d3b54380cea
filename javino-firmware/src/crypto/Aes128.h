#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "Aes128Core.h"

namespace javinolib {

/// The AES-128 block cipher, forward direction only (FIPS 197); CFB and CMAC need no other.
///
/// No branch and no loop depends on key or data. The S-box is read from flash, whose access takes the same time at
/// every address of an AVR, which has no cache. The round keys take 176 bytes, or 32 on a small board;
/// they are wiped at the end of life.
class Aes128 {
 public:
  static const uint8_t BLOCK_LENGTH = 16;
  static const uint8_t KEY_LENGTH = 16;

  /// Without a key: setKey() must come before encrypt().
  Aes128() {}
  explicit Aes128(const uint8_t *key) { setKey(key); }
  JAVINO_NOINLINE ~Aes128();

  /// Expands a key of 16 bytes.
  void setKey(const uint8_t *key) { javino_aes128_expand(roundKeys_, key); }

  /// Encrypts 16 bytes in place.
  void encrypt(uint8_t *block) const { javino_aes128_encrypt(roundKeys_, block, block); }

  /// Encrypts the 16 bytes at `in` to the 16 bytes at `out`: another place, or the same.
  void encrypt(const uint8_t *in, uint8_t *out) const { javino_aes128_encrypt(roundKeys_, in, out); }

#if JAVINO_LARGE
  /// Encrypts the 16 bytes at `in` and adds (XOR) the result to the 16 bytes at `bytes`, then encrypts these and adds the
  /// result to the 16 behind, and so on up to `end`.
  /// @param end a multiple of 16 bytes behind `bytes`, at least 16
  void chainUp(const uint8_t *in, uint8_t *bytes, const uint8_t *end) const {
    javino_aes128_chain(roundKeys_, in, bytes, end, 0);
  }

  /// Undoes chainUp() but for the first block: encrypts the block before the last and adds the result to the last, and so
  /// on down to the second.
  /// @param end a multiple of 16 bytes behind `bytes`, at least 32
  void chainDown(const uint8_t *bytes, uint8_t *end) const {
    javino_aes128_chain(roundKeys_, end - 2 * BLOCK_LENGTH, end - BLOCK_LENGTH, bytes, 2 * BLOCK_LENGTH);
  }
#endif

 private:
  Aes128(const Aes128 &);
  Aes128 &operator=(const Aes128 &);

  mutable uint8_t roundKeys_[JAVINO_ROUND_KEYS_LENGTH];
};

}  // namespace javinolib
