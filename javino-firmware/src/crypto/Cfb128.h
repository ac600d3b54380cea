#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "Aes128.h"

namespace javinolib {

/// AES-128 in CFB mode with segments of 128 bits (NIST SP 800-38A section 6.3), for one message of any length: the last
/// block may be short.
class Cfb128 {
 public:
  /// @param cipher outlives this object
  /// @param iv 16 bytes that outlive this object, never used twice with a key
  Cfb128(const Aes128 &cipher, const uint8_t *iv) : cipher_(cipher), iv_(iv) {}

  /// Encrypts the message in place.
  void encrypt(uint8_t *bytes, uint16_t length) const { apply(cipher_, iv_, bytes, length, false); }

  /// Decrypts the message in place.
  void decrypt(uint8_t *bytes, uint16_t length) const { apply(cipher_, iv_, bytes, length, true); }

 private:
  Cfb128(const Cfb128 &);
  Cfb128 &operator=(const Cfb128 &);

  static void apply(const Aes128 &cipher, const uint8_t *iv, uint8_t *bytes, uint16_t length, bool decrypting);
  JAVINO_NOINLINE static void applyToRest(const Aes128 &cipher, const uint8_t *before, uint8_t *rest, uint8_t length);

  const Aes128 &cipher_;
  const uint8_t *const iv_;
};

}  // namespace javinolib
