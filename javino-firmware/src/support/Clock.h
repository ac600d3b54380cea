#pragma once

#include <stdint.h>

namespace javinolib {

/// The time since the boot. The seam for the core's timer; bound when linking, to ArduinoSeams.cpp on a board and to a
/// clock that the test sets in the host tests.
namespace clock {

/// Milliseconds since the boot; counts up and, after 49 days, around.
uint32_t millis();

}  // namespace clock
}  // namespace javinolib
