// SPDX-License-Identifier: GPL-3.0-or-later
// Emulated time: cycles of 16 MHz since the start, the same on all boards, whatever their own clocks.
#ifndef JAVINO_CLOCK_H
#define JAVINO_CLOCK_H

#include <stdint.h>

typedef uint64_t cycles_t;

#define CYCLES_PER_SECOND 16000000u
#define CYCLES_PER_MS (CYCLES_PER_SECOND / 1000u)
#define CYCLES_PER_US (CYCLES_PER_SECOND / 1000000u)
#define NEVER UINT64_MAX

static inline double cycles_to_seconds(cycles_t cycles) { return (double)cycles / CYCLES_PER_SECOND; }

static inline cycles_t seconds_to_cycles(double seconds) { return (cycles_t)(seconds * CYCLES_PER_SECOND + 0.5); }

#endif
