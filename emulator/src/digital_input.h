// SPDX-License-Identifier: GPL-3.0-or-later
// A pin that something outside drives high and low: a button, a switch, a detector.
#ifndef JAVINO_DIGITAL_INPUT_H
#define JAVINO_DIGITAL_INPUT_H

#include <stdbool.h>

#include "board.h"
#include "sensor_clock.h"

typedef struct {
  board *owner;
  sensor_clock clock;
  cycles_t next_change;
} digital_input;

void digital_input_init(digital_input *sensor, board *owner, const sensor_config *config);
void digital_input_output(digital_input *sensor, int pin, bool level, cycles_t at);

// Hands the board the changes that come before `until`.
void digital_input_advance(digital_input *sensor, cycles_t until);

#endif
