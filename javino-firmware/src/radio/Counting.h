#pragma once

#include <stdint.h>

namespace javino {

/// Adds one; the counter stops at 4294967295 (SPEC 4.5).
inline void countUp(uint32_t &counter) {
  if (counter != UINT32_MAX) counter++;
}

}  // namespace javino
