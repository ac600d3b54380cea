// SPDX-License-Identifier: GPL-3.0-or-later
#include "digital_input.h"

#include <math.h>

// The cycle of the first change after `seconds` on the sensor's clock.
static cycles_t change_after(const digital_input *sensor, double seconds) {
  double next = series_next_change_s(&sensor->clock.config->values, seconds);
  if (sensor->clock.start == NEVER || isinf(next)) return NEVER;
  return sensor->clock.start + seconds_to_cycles(next);
}

void digital_input_init(digital_input *sensor, board *owner, const sensor_config *config) {
  sensor->owner = owner;
  sensor_clock_init(&sensor->clock, config);
  sensor->next_change = change_after(sensor, 0);
  board_drive(owner, config->pin, series_step(&config->values, 0) >= 0.5);
}

void digital_input_output(digital_input *sensor, int pin, bool level, cycles_t at) {
  bool waiting = sensor->clock.start == NEVER;
  sensor_clock_output(&sensor->clock, pin, level, at);
  if (waiting) sensor->next_change = change_after(sensor, 0);
}

void digital_input_advance(digital_input *sensor, cycles_t until) {
  while (sensor->next_change < until) {
    const sensor_config *config = sensor->clock.config;
    cycles_t at = sensor->next_change;
    // Half a cycle later, so that rounding cannot make the same point come again.
    double seconds = sensor_clock_seconds(&sensor->clock, at) + 0.5 / CYCLES_PER_SECOND;
    board_drive_at(sensor->owner, config->pin, series_step(&config->values, seconds) >= 0.5, at);
    sensor->next_change = change_after(sensor, seconds);
  }
}
