// SPDX-License-Identifier: GPL-3.0-or-later
// HC-SR04 ultrasonic distance sensor: a pulse of 10 µs on trigger, and the echo pin is high for as
// long as sound needs there and back (58 µs a centimetre).
#ifndef JAVINO_HC_SR04_H
#define JAVINO_HC_SR04_H

#include <stdbool.h>

#include "board.h"
#include "sensor_clock.h"

typedef struct {
  board *owner;
  sensor_clock clock;
  cycles_t trigger_rise;
  cycles_t busy_until;  // triggers before are ignored, as the sensor does
} hc_sr04;

void hc_sr04_init(hc_sr04 *sensor, board *owner, const sensor_config *config);
void hc_sr04_output(hc_sr04 *sensor, int pin, bool level, cycles_t at);

#endif
