// SPDX-License-Identifier: GPL-3.0-or-later
#include "sensor.h"

#include <math.h>

#include <simavr/avr_adc.h>
#include <simavr/sim_avr.h>

#include "scenario_board.h"

// The HC-SR04, from its data sheet, and for the delay from measurements: eight cycles of 40 kHz and some more.
#define MIN_TRIGGER (10 * CYCLES_PER_US)
#define ECHO_DELAY (450 * CYCLES_PER_US)
#define CYCLES_PER_CM (58 * CYCLES_PER_US)
#define MIN_DISTANCE_CM 2
#define MAX_DISTANCE_CM 400
#define NO_ECHO_PULSE (38 * CYCLES_PER_MS)

#define MAX_READING 1023

// Seconds on the series' clock; 0 as long as it has not started.
static double seconds_at(const sensor *s, cycles_t at) {
  return s->start == NEVER || at < s->start ? 0 : cycles_to_seconds(at - s->start);
}

static double value_at(const sensor *s, double seconds) {
  if (s->held) return s->held_value;
  if (s->config->values.count == 0) return s->world.value(s->world.context, s->config->kind);
  return s->config->kind == SENSOR_DIGITAL ? series_step(&s->config->values, seconds)
                                           : series_linear(&s->config->values, seconds);
}

// What the sensor measures, with its noise.
static double measure(const sensor *s, cycles_t at) {
  double value = value_at(s, seconds_at(s, at));
  if (s->config->noise > 0) value += s->config->noise * prng_normal(s->world.noise);
  return fmin(fmax(value, 0), sensor_most(s->config->kind));
}

static cycles_t echo_length(const sensor *s, cycles_t at) {
  double cm = measure(s, at);
  if (cm > MAX_DISTANCE_CM) return NO_ECHO_PULSE;
  return (cycles_t)((cm < MIN_DISTANCE_CM ? MIN_DISTANCE_CM : cm) * CYCLES_PER_CM);
}

static void trigger_changed(sensor *s, bool level, cycles_t at) {
  if (at < s->busy_until) return;
  if (level) {
    s->trigger_rise = at;
    return;
  }
  if (s->trigger_rise == NEVER || at - s->trigger_rise < MIN_TRIGGER) return;
  cycles_t rise = at + ECHO_DELAY;
  s->busy_until = rise + echo_length(s, at);
  s->trigger_rise = NEVER;
  board_drive_at(s->owner, s->config->pin, true, rise);
  board_drive_at(s->owner, s->config->pin, false, s->busy_until);
}

static void conversion_started(struct avr_irq_t *irq, uint32_t value, void *context) {
  const sensor *s = context;
  (void)irq;
  (void)value;
  double reading = round(measure(s, board_now(s->owner)));
  // Rounded up, as the converter rounds down.
  avr_raise_irq(s->channel, (uint32_t)ceil(reading * s->owner->model->supply_mv / MAX_READING));
}

static void connect_to_converter(sensor *s) {
  struct avr_t *avr = s->owner->avr;
  s->channel = avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, s->config->pin - s->owner->model->pin_a0);
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER), conversion_started, s);
}

static bool driven_high(const sensor *s, double seconds) { return value_at(s, seconds) >= 0.5; }

static cycles_t change_after(const sensor *s, double seconds) {
  if (s->config->kind != SENSOR_DIGITAL || s->start == NEVER) return NEVER;
  double next = series_next_change_s(&s->config->values, seconds);
  if (isinf(next)) return NEVER;
  return s->start + seconds_to_cycles(next);
}

void sensor_init(sensor *s, board *owner, const sensor_config *config, sensor_world world) {
  bool waits = config->after_pin >= 0;
  *s = (sensor){.owner = owner, .config = config, .world = world, .start = waits ? NEVER : 0, .trigger_rise = NEVER};
  s->next_change = change_after(s, 0);
  if (waits) board_observe(owner, config->after_pin);
  switch (config->kind) {
    case SENSOR_HC_SR04:
      board_observe(owner, config->trigger);
      board_drive(owner, config->pin, false);
      break;
    case SENSOR_LDR: connect_to_converter(s); break;
    case SENSOR_DIGITAL: board_drive(owner, config->pin, driven_high(s, 0)); break;
  }
}

static void drive_now(sensor *s) {
  if (s->config->kind != SENSOR_DIGITAL) return;
  board_drive(s->owner, s->config->pin, driven_high(s, seconds_at(s, board_now(s->owner))));
}

void sensor_hold(sensor *s, double value) {
  s->held = true;
  s->held_value = value;
  drive_now(s);
}

void sensor_release(sensor *s) {
  s->held = false;
  drive_now(s);
}

void sensor_output(sensor *s, int pin, bool level, cycles_t at) {
  if (s->start == NEVER && pin == s->config->after_pin && level == s->config->after_level) {
    s->start = at;
    s->next_change = change_after(s, 0);
  }
  if (s->config->kind == SENSOR_HC_SR04 && pin == s->config->trigger) trigger_changed(s, level, at);
}

void sensor_advance(sensor *s, cycles_t until) {
  while (s->next_change < until) {
    cycles_t at = s->next_change;
    // Half a cycle later, so that rounding cannot make the same point come again.
    double seconds = seconds_at(s, at) + 0.5 / CYCLES_PER_SECOND;
    board_drive_at(s->owner, s->config->pin, driven_high(s, seconds), at);
    s->next_change = change_after(s, seconds);
  }
}

cycles_t sensor_next_event(const sensor *s) { return s->next_change; }
