#pragma once

#include <stdint.h>

#include "../support/Inlining.h"

#include "Aes128.h"

namespace javinolib {

/// The part of a shared key that the board keeps, and wipes when done with it (SPEC 5.2). The key itself is not kept: nothing
/// needs it again, and to derive these anew for each packet would cost six blocks of AES and three key expansions.
struct DerivedKeys {
  static const uint8_t CHECK_LENGTH = 3;

  uint8_t check[CHECK_LENGTH];                 ///< the check value, which is no secret
  uint8_t encryption[Aes128::KEY_LENGTH];      ///< Kenc
  uint8_t authentication[Aes128::KEY_LENGTH];  ///< Kmac

  ~DerivedKeys();

  /// Derives all three from a shared key of 16 bytes (NIST SP 800-108 section 4.1, counter mode).
  JAVINO_NOINLINE void derive(const uint8_t *key);

  /// Computes AES-CMAC under Kmac. Expands the key, some 200 bytes of stack, and wipes them.
  /// @param tag room for 16 bytes; it may be where the message begins
  JAVINO_NOINLINE void authenticate(const uint8_t *message, uint16_t length, uint8_t *tag) const;

  /// Compares in constant time.
  bool equals(const DerivedKeys &other) const;
};

}  // namespace javinolib
