// SPDX-License-Identifier: GPL-3.0-or-later
#include "sleep.h"

#include <string.h>

#include <simavr/avr_adc.h>
#include <simavr/avr_timer.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>

// Data space addresses and bits, on the ATmega2560 and the ATmega328P alike.
#define SMCR 0x53
#define SE 1
#define ADCSRA 0x7A
#define ADEN 0x80
#define ADSC 0x40
#define ADIF 0x10

enum { IDLE, ADC_NOISE_REDUCTION, POWER_DOWN, POWER_SAVE, STANDBY = 6, EXTENDED_STANDBY };

// Cycles until the chip runs again, with the fuses that Arduinos have: a crystal, slowly rising power.
#define CRYSTAL_START 16384
#define STANDBY_START 6

_Static_assert(SLEEP_MAX_TIMERS >= MAX_CYCLE_TIMERS, "room for all of simavr's timers");

static bool is_kind(const avr_io_t *part, const char *kind) { return part->kind && strcmp(part->kind, kind) == 0; }

static bool has_asynchronous_clock(const sleep_clocks *s) {
  return s->mode == ADC_NOISE_REDUCTION || s->mode == POWER_SAVE || s->mode == EXTENDED_STANDBY;
}

static bool is_asynchronous(const sleep_clocks *s, const avr_io_t *part) {
  const avr_timer_t *timer = (const avr_timer_t *)part;  // each part begins with its avr_io_t
  return is_kind(part, "timer") && timer->as2.reg && avr_regbit_get(s->avr, timer->as2);
}

// The watchdog has an oscillator of its own; so has the EEPROM, whose timers are not simavr's.
static bool stands_still(const sleep_clocks *s, const avr_io_t *part) {
  if (is_kind(part, "watchdog")) return false;
  if (is_kind(part, "adc")) return s->mode != ADC_NOISE_REDUCTION;
  return !(is_asynchronous(s, part) && has_asynchronous_clock(s));
}

static const avr_io_t *part_at(const sleep_clocks *s, const void *address) {
  const avr_io_t *part = s->avr->io_port;
  while (part && part != address) part = part->next;
  return part;
}

static bool wakes(const sleep_clocks *s, uint8_t vector) {
  const model_wakes *w = &s->model->wakes;
  uint64_t bit = 1ull << vector;
  if (vector >= w->level_first && vector < w->level_first + w->level_count)
    return (s->avr->data[w->level_control] >> 2 * (vector - w->level_first) & 3) == 0;
  if (w->timer_2 & bit) return has_asynchronous_clock(s);
  return (w->always | (s->mode == ADC_NOISE_REDUCTION ? w->adc_noise_reduction : 0)) & bit;
}

// simavr wakes the chip by any interrupt that is enabled, so the others are not while it sleeps; nor is their flag set.
static void mask(sleep_clocks *s) {
  const avr_int_table_t *table = &s->avr->interrupts;
  s->masked = s->raised = 0;
  for (int i = 0; i < table->vector_count; i++) {
    const avr_int_vector_t *vector = table->vector[i];
    if (wakes(s, vector->vector)) continue;
    if (vector->raised.reg && avr_regbit_get(s->avr, vector->raised)) s->raised |= 1ull << i;
    if (!avr_regbit_get(s->avr, vector->enable)) continue;
    s->masked |= 1ull << i;
    avr_regbit_clear(s->avr, vector->enable);
  }
}

static void unmask(sleep_clocks *s) {
  const avr_int_table_t *table = &s->avr->interrupts;
  for (int i = 0; i < table->vector_count; i++) {
    const avr_int_vector_t *vector = table->vector[i];
    if (wakes(s, vector->vector)) continue;
    if (vector->raised.reg) avr_regbit_setto(s->avr, vector->raised, s->raised >> i & 1);
    if (s->masked >> i & 1) avr_regbit_set(s->avr, vector->enable);
  }
}

static void stop_clocks(sleep_clocks *s) {
  s->stopped = true;
  s->starting = false;
  s->stopped_at = s->avr->cycle;
  s->timer_count = 0;
  for (const avr_cycle_timer_slot_t *t = s->avr->cycle_timers.timer; t; t = t->next) {
    const avr_io_t *part = part_at(s, t->param);
    if (!part || !stands_still(s, part)) continue;
    uint64_t left = t->when > s->stopped_at ? t->when - s->stopped_at : 0;
    s->timers[s->timer_count].left = left;
    s->timers[s->timer_count].run = t->timer;
    s->timers[s->timer_count++].part = t->param;
  }
  for (size_t i = 0; i < s->timer_count; i++) avr_cycle_timer_cancel(s->avr, s->timers[i].run, s->timers[i].part);
  mask(s);
}

static void start_clocks(sleep_clocks *s) {
  unmask(s);
  for (avr_io_t *part = s->avr->io_port; part; part = part->next) {
    if (!is_kind(part, "timer") || !stands_still(s, part)) continue;
    avr_timer_t *timer = (avr_timer_t *)part;
    if (timer->tov_cycles) timer->tov_base += s->avr->cycle - s->stopped_at;
  }
  for (size_t i = 0; i < s->timer_count; i++)
    avr_cycle_timer_register(s->avr, s->timers[i].left, s->timers[i].run, s->timers[i].part);
  s->stopped = false;
}

// A conversion begins with this mode, if the converter is on and idle.
static void begin_conversion(sleep_clocks *s) {
  uint8_t control = s->avr->data[ADCSRA];
  if ((control & (ADEN | ADSC)) != ADEN) return;
  s->avr->io[AVR_DATA_TO_IO(ADCSRA)].w.c(s->avr, ADCSRA, (uint8_t)((control & ~ADIF) | ADSC),
                                         s->avr->io[AVR_DATA_TO_IO(ADCSRA)].w.param);
}

void sleep_init(sleep_clocks *s, struct avr_t *avr, const model *m) {
  memset(s, 0, sizeof *s);
  s->avr = avr;
  s->model = m;
}

void sleep_begin(sleep_clocks *s) {
  uint8_t control = s->avr->data[SMCR];
  if (!(control & SE)) {
    s->avr->state = cpu_Running;
    return;
  }
  s->mode = control >> 1 & 7;
  if (s->mode == IDLE) return;
  if (s->mode == ADC_NOISE_REDUCTION) begin_conversion(s);
  stop_clocks(s);
}

bool sleep_is_over(sleep_clocks *s) {
  if (!s->stopped) return true;
  if (!s->starting) {
    bool has_crystal = s->mode == ADC_NOISE_REDUCTION;
    bool stands_by = s->mode == STANDBY || s->mode == EXTENDED_STANDBY;
    s->starting = true;
    s->started_at = s->avr->cycle + (has_crystal ? 0 : stands_by ? STANDBY_START : CRYSTAL_START);
  }
  if (s->avr->cycle < s->started_at) return false;
  start_clocks(s);
  return true;
}

void sleep_reset(sleep_clocks *s) { s->stopped = false; }
