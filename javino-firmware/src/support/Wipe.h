#pragma once

#include <stddef.h>
#include <stdint.h>

#include "Inlining.h"

namespace javinolib {

/// Overwrites a secret with zeroes in a way that the compiler may not leave out, though nobody reads it afterwards.
JAVINO_NOINLINE void wipe(void *secret, size_t length);

}  // namespace javinolib
