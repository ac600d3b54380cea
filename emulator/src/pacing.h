// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps emulated time in step with the wall clock, without ever waiting busily.
#ifndef JAVINO_PACING_H
#define JAVINO_PACING_H

#include <poll.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clock.h"

// Emulated time runs at most so far between two exchanges with the hosts.
#define PACING_SLICE CYCLES_PER_MS
// How long the process sleeps when it is ahead, and how long while bytes are on their way to a host or from it: these
// are that late at most.
#define PACING_TICK_NS 1000000
#define PACING_SERIAL_TICK_NS 200000
#define PACING_PAUSED_TICK_NS 20000000
// A debt greater than this is given up.
#define PACING_MAX_DEBT_NS 100000000

typedef struct {
  double speed;         // emulated seconds a second; 0: as fast as possible
  bool paused;          // emulated time stands still
  int64_t origin_ns;    // wall clock at emulated time 0, moved when a debt is given up
  int64_t given_up_ns;  // sum of all debts given up
} pacing;

// Starts at emulated time 0.
void pacing_start(pacing *p, double speed);

// Emulated time runs at `speed` from `now` on; 0: it stands still.
void pacing_change(pacing *p, double speed, cycles_t now);

// How far to run now: between `now`, when it is too early for more, and `now` + PACING_SLICE.
cycles_t pacing_due(pacing *p, cycles_t now);

// Sleeps for a tick, which is short while a serial line is busy and long while time stands still, or until one of the
// descriptors is ready.
void pacing_wait(const pacing *p, struct pollfd *descriptors, size_t count, bool serial_busy);

#endif
