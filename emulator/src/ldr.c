// SPDX-License-Identifier: GPL-3.0-or-later
#include "ldr.h"

#include <math.h>

#include <simavr/avr_adc.h>
#include <simavr/sim_avr.h>

#define MAX_READING 1023

// The program starts a conversion: only now the value matters.
static void conversion_started(struct avr_irq_t *irq, uint32_t value, void *context) {
  ldr *sensor = context;
  (void)irq;
  (void)value;
  double seconds = sensor_clock_seconds(&sensor->clock, board_now(sensor->owner));
  double reading = round(series_linear(&sensor->clock.config->values, seconds));
  // Rounded up, as the converter rounds down.
  avr_raise_irq(sensor->channel, (uint32_t)ceil(reading * sensor->owner->model->supply_mv / MAX_READING));
}

void ldr_init(ldr *sensor, board *owner, const sensor_config *config) {
  sensor->owner = owner;
  sensor_clock_init(&sensor->clock, config);
  sensor->channel = avr_io_getirq(owner->avr, AVR_IOCTL_ADC_GETIRQ, config->pin - owner->model->pin_a0);
  avr_irq_register_notify(avr_io_getirq(owner->avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER), conversion_started,
                          sensor);
}

void ldr_output(ldr *sensor, int pin, bool level, cycles_t at) { sensor_clock_output(&sensor->clock, pin, level, at); }
