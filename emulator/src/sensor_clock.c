// SPDX-License-Identifier: GPL-3.0-or-later
#include "sensor_clock.h"

void sensor_clock_init(sensor_clock *clock, const sensor_config *config) {
  clock->config = config;
  clock->start = config->after_pin < 0 ? 0 : NEVER;
}

void sensor_clock_output(sensor_clock *clock, int pin, bool level, cycles_t at) {
  if (clock->start == NEVER && pin == clock->config->after_pin && level == clock->config->after_level)
    clock->start = at;
}

double sensor_clock_seconds(const sensor_clock *clock, cycles_t at) {
  return clock->start == NEVER || at < clock->start ? 0 : cycles_to_seconds(at - clock->start);
}
