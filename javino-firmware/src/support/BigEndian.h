#pragma once

#include <stdint.h>

#include "Inlining.h"

namespace javinolib {

/// A number of 24 bits, in three bytes where the compiler has such a type. Sums may need more.
#ifdef __AVR__
typedef __uint24 Uint24;
#else
typedef uint32_t Uint24;
#endif

/// Numbers of several bytes as the protocol has them, most significant byte first (SPEC, conventions).

void writeUint24(uint8_t *into, Uint24 value);
void writeUint32(uint8_t *into, uint32_t value);
JAVINO_NOINLINE uint32_t readUint24(const uint8_t *from);

}  // namespace javinolib
