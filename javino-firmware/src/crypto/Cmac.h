#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "Aes128.h"

namespace javinolib {

/// AES-CMAC (NIST SP 800-38B section 6) under one key, whose subkey is computed once.
class Cmac {
 public:
  /// @param cipher outlives this object
  explicit Cmac(const Aes128 &cipher);
  ~Cmac();

  /// Computes the tag of a message.
  /// @param length 0…65535 bytes
  /// @param tag room for the 16 bytes of the untruncated tag; it may be where the message begins
  void compute(const uint8_t *message, uint16_t length, uint8_t *tag) const;

 private:
  Cmac(const Cmac &);
  Cmac &operator=(const Cmac &);

  const Aes128 &cipher_;
  uint8_t subkey_[Aes128::BLOCK_LENGTH];  // K1
};

/// Computes the tag of a single message.
void cmac(const Aes128 &cipher, const uint8_t *message, uint16_t length, uint8_t *tag);

/// Compares in a time that depends on the length only.
bool equalInConstantTime(const uint8_t *some, const uint8_t *other, uint8_t length);

}  // namespace javinolib
