// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of a sensor's series: starts with the emulation, or when a pin first has a level.
#ifndef JAVINO_SENSOR_CLOCK_H
#define JAVINO_SENSOR_CLOCK_H

#include <stdbool.h>

#include "clock.h"
#include "scenario.h"

typedef struct {
  const sensor_config *config;
  cycles_t start;  // NEVER: not yet
} sensor_clock;

void sensor_clock_init(sensor_clock *clock, const sensor_config *config);

// A pin of the board changed its output level.
void sensor_clock_output(sensor_clock *clock, int pin, bool level, cycles_t at);

// Seconds on this clock; 0 before it starts.
double sensor_clock_seconds(const sensor_clock *clock, cycles_t at);

#endif
