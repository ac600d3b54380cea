// SPDX-License-Identifier: GPL-3.0-or-later
// What analogWrite() does: the duty that a timer gives a pin, by the timer's registers, as simavr drives no pin by it.
#ifndef JAVINO_PWM_H
#define JAVINO_PWM_H

struct avr_t;
struct pwm_timer;

typedef struct {
  void *context;
  // The share of time for which the pin is high, 0…1; negative: the pin has the level of the program again.
  void (*duty)(void *context, char port, int bit, double duty);
} pwm_listener;

typedef struct {
  struct pwm_timer *timers;
  pwm_listener listener;
} pwm;

void pwm_init(pwm *p, struct avr_t *avr, pwm_listener listener);
void pwm_release(pwm *p);

// No timer has a pin any more, as after a reset.
void pwm_reset(pwm *p);

#endif
