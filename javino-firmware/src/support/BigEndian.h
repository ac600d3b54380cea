#pragma once

#include <stdint.h>

#include "Inlining.h"

namespace javinolib {

/// Numbers of several bytes as the protocol has them, most significant byte first (SPEC, conventions).

void writeUint24(uint8_t *into, uint32_t value);
void writeUint32(uint8_t *into, uint32_t value);
JAVINO_NOINLINE uint32_t readUint24(const uint8_t *from);

}  // namespace javinolib
