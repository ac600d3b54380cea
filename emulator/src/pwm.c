// SPDX-License-Identifier: GPL-3.0-or-later
#include "pwm.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/avr_ioport.h>
#include <simavr/avr_timer.h>
#include <simavr/sim_avr.h>

#define NONE (-1.0)

struct pwm_timer {
  pwm *owner;
  avr_timer_t *timer;
  struct {
    char port;  // 0: there is no such comparator
    double duty;
  } outputs[AVR_TIMER_COMP_COUNT];
  struct pwm_timer *next;
};

static bool is_kind(const avr_io_t *part, const char *kind) { return part->kind && strcmp(part->kind, kind) == 0; }

static char port_of(const struct avr_t *avr, unsigned reg) {
  for (const avr_io_t *part = avr->io_port; part; part = part->next)
    // Each part begins with its avr_io_t.
    if (is_kind(part, "port") && ((const avr_ioport_t *)part)->r_port == reg) return ((const avr_ioport_t *)part)->name;
  return 0;
}

static unsigned read_word(const struct avr_t *avr, avr_io_addr_t low, avr_io_addr_t high) {
  return avr->data[low] | (high ? (unsigned)avr->data[high] << 8 : 0);
}

static double duty_of(const avr_timer_t *timer, int index) {
  struct avr_t *avr = timer->io.avr;
  const avr_timer_comp_t *comp = &timer->comp[index];
  if (timer->mode.kind != avr_timer_wgm_pwm && timer->mode.kind != avr_timer_wgm_fast_pwm) return NONE;
  int output = avr_regbit_get(avr, comp->com);
  if (output != avr_timer_com_clear && output != avr_timer_com_set) return NONE;
  unsigned top = (1u << timer->mode.size) - 1;
  if (timer->mode.top == avr_timer_wgm_reg_icr) top = read_word(avr, timer->r_icr, timer->r_icrh);
  if (timer->mode.top == avr_timer_wgm_reg_ocra) top = read_word(avr, timer->comp[0].r_ocr, timer->comp[0].r_ocrh);
  unsigned value = read_word(avr, comp->r_ocr, comp->r_ocrh);
  double share = top == 0 || value >= top ? 1 : (double)value / top;
  return output == avr_timer_com_clear ? share : 1 - share;
}

static void set_duty(struct pwm_timer *t, int index, double duty) {
  if (t->outputs[index].duty == duty) return;
  t->outputs[index].duty = duty;
  t->owner->listener.duty(t->owner->listener.context, t->outputs[index].port, t->timer->comp[index].com_pin.bit, duty);
}

static void register_written(struct avr_irq_t *irq, uint32_t value, void *context) {
  struct pwm_timer *t = context;
  (void)irq;
  (void)value;
  for (int i = 0; i < AVR_TIMER_COMP_COUNT; i++)
    if (t->outputs[i].port) set_duty(t, i, duty_of(t->timer, i));
}

static void observe(struct pwm_timer *t, avr_io_addr_t reg) {
  avr_irq_register_notify(avr_iomem_getirq(t->timer->io.avr, reg, NULL, AVR_IOMEM_IRQ_ALL), register_written, t);
}

void pwm_init(pwm *p, struct avr_t *avr, pwm_listener listener) {
  *p = (pwm){.listener = listener};
  for (avr_io_t *part = avr->io_port; part; part = part->next) {
    if (!is_kind(part, "timer")) continue;
    struct pwm_timer *t = calloc(1, sizeof *t);
    if (!t) abort();  // out of memory: nothing sensible is left to do
    *t = (struct pwm_timer){.owner = p, .timer = (avr_timer_t *)part, .next = p->timers};
    p->timers = t;
    for (int i = 0; i < AVR_TIMER_COMP_COUNT; i++) {
      const avr_timer_comp_t *comp = &t->timer->comp[i];
      t->outputs[i].duty = NONE;
      t->outputs[i].port = comp->com.reg && comp->com_pin.reg ? port_of(avr, comp->com_pin.reg) : 0;
      if (!t->outputs[i].port) continue;
      observe(t, comp->com.reg);
      observe(t, comp->r_ocr);
    }
  }
}

void pwm_release(pwm *p) {
  while (p->timers) {
    struct pwm_timer *t = p->timers;
    p->timers = t->next;
    free(t);
  }
}

void pwm_reset(pwm *p) {
  for (struct pwm_timer *t = p->timers; t; t = t->next)
    for (int i = 0; i < AVR_TIMER_COMP_COUNT; i++) set_duty(t, i, NONE);
}
