// SPDX-License-Identifier: GPL-3.0-or-later
#include "hc_sr04.h"

// From the data sheet, and for the delay from measurements: eight cycles of 40 kHz and some more.
#define MIN_TRIGGER (10 * CYCLES_PER_US)
#define ECHO_DELAY (450 * CYCLES_PER_US)
#define CYCLES_PER_CM (58 * CYCLES_PER_US)
#define MIN_DISTANCE_CM 2
#define MAX_DISTANCE_CM 400
#define NO_ECHO_PULSE (38 * CYCLES_PER_MS)

void hc_sr04_init(hc_sr04 *sensor, board *owner, const sensor_config *config) {
  *sensor = (hc_sr04){.owner = owner, .trigger_rise = NEVER};
  sensor_clock_init(&sensor->clock, config);
  board_observe(owner, config->trigger);
  board_drive(owner, config->pin, false);
}

static cycles_t pulse_length(const hc_sr04 *sensor, cycles_t at) {
  double cm = series_linear(&sensor->clock.config->values, sensor_clock_seconds(&sensor->clock, at));
  if (cm > MAX_DISTANCE_CM) return NO_ECHO_PULSE;
  return (cycles_t)((cm < MIN_DISTANCE_CM ? MIN_DISTANCE_CM : cm) * CYCLES_PER_CM);
}

void hc_sr04_output(hc_sr04 *sensor, int pin, bool level, cycles_t at) {
  sensor_clock_output(&sensor->clock, pin, level, at);
  if (pin != sensor->clock.config->trigger || at < sensor->busy_until) return;
  if (level) {
    sensor->trigger_rise = at;
    return;
  }
  if (sensor->trigger_rise == NEVER || at - sensor->trigger_rise < MIN_TRIGGER) return;
  cycles_t rise = at + ECHO_DELAY;
  cycles_t fall = rise + pulse_length(sensor, at);
  board_drive_at(sensor->owner, sensor->clock.config->pin, true, rise);
  board_drive_at(sensor->owner, sensor->clock.config->pin, false, fall);
  sensor->trigger_rise = NEVER;
  sensor->busy_until = fall;
}
