// SPDX-License-Identifier: GPL-3.0-or-later
#include "sensor.h"

void sensor_init(sensor *s, board *owner, const sensor_config *config) {
  s->kind = config->kind;
  if (config->after_pin >= 0) board_observe(owner, config->after_pin);
  switch (s->kind) {
    case SENSOR_HC_SR04: hc_sr04_init(&s->part.ultrasonic, owner, config); break;
    case SENSOR_LDR: ldr_init(&s->part.light, owner, config); break;
    case SENSOR_DIGITAL: digital_input_init(&s->part.digital, owner, config); break;
  }
}

void sensor_output(sensor *s, int pin, bool level, cycles_t at) {
  switch (s->kind) {
    case SENSOR_HC_SR04: hc_sr04_output(&s->part.ultrasonic, pin, level, at); break;
    case SENSOR_LDR: ldr_output(&s->part.light, pin, level, at); break;
    case SENSOR_DIGITAL: digital_input_output(&s->part.digital, pin, level, at); break;
  }
}

void sensor_advance(sensor *s, cycles_t until) {
  if (s->kind == SENSOR_DIGITAL) digital_input_advance(&s->part.digital, until);
}

cycles_t sensor_next_event(const sensor *s) { return s->kind == SENSOR_DIGITAL ? s->part.digital.next_change : NEVER; }
