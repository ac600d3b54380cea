#pragma once

#include <stdint.h>

namespace javinolib {

/// The first byte of each reply (SPEC 4.4).
enum class Status : uint8_t {
#define STATUS(name, meaning, explanation) name,
#include "Statuses.def"
#undef STATUS
};

}  // namespace javinolib
