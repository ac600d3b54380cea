// SPDX-License-Identifier: GPL-3.0-or-later
// Fills a gap of simavr: it knows no phase-correct PWM, and a timer in such a mode overflows at
// each of its clocks. The Arduino core puts timers 1 to 5 into that mode at start.
#ifndef JAVINO_TIMER_MODES_H
#define JAVINO_TIMER_MODES_H

struct avr_t;

// Takes phase-correct PWM of 8, 9 and 10 bits as fast PWM of the same width, which overflows twice
// as often as the chip would. An idle Arduino then takes a fifteenth of the work.
void timer_modes_complete(struct avr_t *avr);

#endif
