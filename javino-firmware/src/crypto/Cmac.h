#pragma once

#include <stdint.h>

#include "Aes128.h"

namespace javino {

/// Computes the AES-CMAC of a message (NIST SP 800-38B section 6.2).
/// @param length 0…65535 bytes
/// @param tag room for the 16 bytes of the untruncated tag
void cmac(const Aes128 &cipher, const uint8_t *message, uint16_t length, uint8_t *tag);

/// Compares in a time that depends on the length only.
bool equalInConstantTime(const uint8_t *some, const uint8_t *other, uint8_t length);

}  // namespace javino
