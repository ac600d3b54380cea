// SPDX-License-Identifier: GPL-3.0-or-later
// The sensors that a scenario can put on a board:
// - HC-SR04, for distances: after a pulse of 10 µs on trigger the echo pin is high for as long as sound needs there and
//   back (58 µs a centimetre);
// - a light-dependent resistor in a divider on an analog pin;
// - a pin that something outside drives high and low: a button, a switch, a detector.
#ifndef JAVINO_SENSOR_H
#define JAVINO_SENSOR_H

#include <stdbool.h>

#include "board.h"
#include "scenario.h"

// The source of values for a sensor without a series, and of what they vary by.
typedef struct {
  void *context;
  double (*value)(void *context, sensor_kind kind);
  prng *noise;
} sensor_world;

typedef struct {
  board *owner;
  const sensor_config *config;
  sensor_world world;
  bool held;  // it measures this, whatever series and world say
  double held_value;
  cycles_t start;  // of the series' clock; NEVER: not yet
  // HC-SR04.
  cycles_t trigger_rise;
  cycles_t busy_until;  // triggers before are ignored, as the sensor does
  // Light-dependent resistor.
  struct avr_irq_t *channel;
  // Driven pin.
  cycles_t next_change;
} sensor;

// The sensor must stay where it is from now on.
void sensor_init(sensor *s, board *owner, const sensor_config *config, sensor_world world);

// The sensor measures this from now on, until sensor_release.
void sensor_hold(sensor *s, double value);
void sensor_release(sensor *s);

// A pin of the board has changed.
void sensor_output(sensor *s, int pin, bool level, cycles_t at);

// Hands the board the changes that come before `until`.
void sensor_advance(sensor *s, cycles_t until);

// When the sensor changes next by itself; NEVER if not.
cycles_t sensor_next_event(const sensor *s);

#endif
