#pragma once

#include <stdint.h>

#include "../support/NoInline.h"
#include "Aes128.h"

namespace javino {

/// AES-128 in CFB mode with segments of 128 bits (NIST SP 800-38A section 6.3), as a stream: any number of bytes a
/// call, the last block may be short. One object either encrypts or decrypts one message.
class Cfb128 {
 public:
  /// @param cipher outlives this object
  /// @param iv 16 bytes, never used twice with a key
  JAVINO_NOINLINE Cfb128(const Aes128 &cipher, const uint8_t *iv);
  JAVINO_NOINLINE ~Cfb128();

  /// Encrypts the next bytes in place. Fastest where all calls but the last have whole blocks of 16 bytes.
  void encrypt(uint8_t *bytes, uint16_t length) { apply(bytes, length, false); }

  /// Decrypts the next bytes in place. Fastest where all calls but the last have whole blocks of 16 bytes.
  void decrypt(uint8_t *bytes, uint16_t length) { apply(bytes, length, true); }

 private:
  Cfb128(const Cfb128 &);
  Cfb128 &operator=(const Cfb128 &);

  JAVINO_NOINLINE void apply(uint8_t *bytes, uint16_t length, bool decrypting);
  void encryptBlocks(uint8_t *bytes, const uint8_t *end);
  void decryptBlocks(uint8_t *bytes, uint8_t *end);
  uint8_t *keyStreamByte();

  const Aes128 &cipher_;
  uint8_t block_[Aes128::BLOCK_LENGTH];  // key stream; behind the current byte of it, the ciphertext so far
  uint8_t used_;                         // bytes of the block that are ciphertext by now
};

}  // namespace javino
