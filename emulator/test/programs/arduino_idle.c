// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the timers as the Arduino core does at start, phase-correct PWM of 8 bits, and sleeps.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

int main(void) {
  TCCR3B = TCCR4B = TCCR5B = _BV(CS31) | _BV(CS30);
  TCCR3A = TCCR4A = TCCR5A = _BV(WGM30);
  set_sleep_mode(SLEEP_MODE_IDLE);
  sei();
  for (;;) sleep_mode();
}
