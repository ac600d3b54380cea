// SPDX-License-Identifier: GPL-3.0-or-later
#include "timer_modes.h"

#include <string.h>

#include <simavr/avr_timer.h>
#include <simavr/sim_avr.h>

// The mode bits of phase-correct PWM, 8 bits: 1 on all timers; 9 and 10 bits: 2 and 3 on those of
// 16 bits, where 8-bit timers have other modes that simavr knows (ATmega2560 data sheet,
// tables 16-8 and 17-2).
#define FIRST_MODE 1
#define LAST_MODE 3
#define FIRST_WIDTH 8

static void complete(avr_timer_t *timer) {
  for (int mode = FIRST_MODE; mode <= LAST_MODE; mode++)
    if (timer->wgm_op[mode].kind == avr_timer_wgm_none)
      timer->wgm_op[mode] =
          (avr_timer_wgm_t){.kind = avr_timer_wgm_fast_pwm, .size = (uint32_t)(FIRST_WIDTH + mode - FIRST_MODE) & 0xF};
}

void timer_modes_complete(struct avr_t *avr) {
  for (avr_io_t *part = avr->io_port; part; part = part->next)
    if (part->kind && strcmp(part->kind, "timer") == 0)
      complete((avr_timer_t *)part);  // each part begins with its avr_io_t
}
