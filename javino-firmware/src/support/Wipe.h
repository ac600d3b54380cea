#pragma once

#include <stddef.h>
#include <stdint.h>

namespace javino {

/// Overwrites a secret with zeroes in a way that the compiler may not leave out, though nobody reads it afterwards.
inline void wipe(void *secret, size_t length) {
  volatile uint8_t *byte = static_cast<volatile uint8_t *>(secret);
  while (length-- > 0) *byte++ = 0;
}

}  // namespace javino
