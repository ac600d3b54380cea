// SPDX-License-Identifier: GPL-3.0-or-later
#include "pacing.h"

#include <time.h>

static int64_t wall_ns(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (int64_t)time.tv_sec * 1000000000 + time.tv_nsec;
}

void pacing_start(pacing *p, double speed) { *p = (pacing){.speed = speed, .origin_ns = wall_ns()}; }

void pacing_change(pacing *p, double speed, cycles_t now) {
  p->paused = speed <= 0;
  p->speed = speed;
  if (!p->paused) p->origin_ns = wall_ns() - (int64_t)((double)now / (speed * CYCLES_PER_SECOND / 1e9));
}

cycles_t pacing_due(pacing *p, cycles_t now) {
  if (p->paused) return now;
  if (p->speed <= 0) return now + PACING_SLICE;
  double cycles_per_ns = p->speed * CYCLES_PER_SECOND / 1e9;
  int64_t elapsed_ns = wall_ns() - p->origin_ns;
  int64_t debt_ns = elapsed_ns - (int64_t)((double)now / cycles_per_ns);
  if (debt_ns > PACING_MAX_DEBT_NS) {
    p->origin_ns += debt_ns;
    p->given_up_ns += debt_ns;
    elapsed_ns -= debt_ns;
  }
  cycles_t due = (cycles_t)((double)elapsed_ns * cycles_per_ns);
  if (due < now) return now;
  return due < now + PACING_SLICE ? due : now + PACING_SLICE;
}

void pacing_wait(const pacing *p, struct pollfd *descriptors, size_t count, bool serial_busy) {
  struct timespec tick = {0, p->paused ? PACING_PAUSED_TICK_NS : serial_busy ? PACING_SERIAL_TICK_NS : PACING_TICK_NS};
  ppoll(descriptors, count, &tick, NULL);
}
