// SPDX-License-Identifier: GPL-3.0-or-later
// A light-dependent resistor in a divider on an analog pin.
#ifndef JAVINO_LDR_H
#define JAVINO_LDR_H

#include <stdbool.h>

#include "board.h"
#include "sensor_clock.h"

typedef struct {
  board *owner;
  sensor_clock clock;
  struct avr_irq_t *channel;
} ldr;

void ldr_init(ldr *sensor, board *owner, const sensor_config *config);
void ldr_output(ldr *sensor, int pin, bool level, cycles_t at);

#endif
