#pragma once

#include <stdint.h>

#include "Inlining.h"

#ifdef __AVR__
#include <avr/io.h>
#endif

namespace javinolib {

/// Tells an observer of the chip, such as the emulator, what a board does: a transition of its automata is a write to a general
/// purpose register, of two cycles. It is in each program, so that what is checked is what users flash.
namespace trace {

enum Point : uint8_t {
  NO_POINT,
#define POINT(name, first, second) name,
#include "TracePoints.h"
#undef POINT
};

#ifdef GPIOR0

/// Tells a point; not in interrupts, which would come between it and its operands.
JAVINO_INLINE void tell(Point point) { GPIOR0 = point; }

JAVINO_INLINE void tell(Point point, uint8_t first) {
  GPIOR1 = first;
  tell(point);
}

JAVINO_INLINE void tell(Point point, uint8_t first, uint8_t second) {
  GPIOR2 = second;
  tell(point, first);
}

#else

inline void tell(Point) {}
inline void tell(Point, uint8_t) {}
inline void tell(Point, uint8_t, uint8_t) {}

#endif

}  // namespace trace
}  // namespace javinolib
