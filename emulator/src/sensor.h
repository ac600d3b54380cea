// SPDX-License-Identifier: GPL-3.0-or-later
// Any of the sensors that a scenario can put on a board.
#ifndef JAVINO_SENSOR_H
#define JAVINO_SENSOR_H

#include "digital_input.h"
#include "hc_sr04.h"
#include "ldr.h"

typedef struct {
  sensor_kind kind;
  union {
    hc_sr04 ultrasonic;
    ldr light;
    digital_input digital;
  } part;
} sensor;

// The sensor must stay where it is from now on.
void sensor_init(sensor *s, board *owner, const sensor_config *config);

// A pin of the board changed its output level.
void sensor_output(sensor *s, int pin, bool level, cycles_t at);

// The board is about to run up to `until`.
void sensor_advance(sensor *s, cycles_t until);

// When the sensor changes a pin by itself next.
cycles_t sensor_next_event(const sensor *s);

#endif
