// SPDX-License-Identifier: GPL-3.0-or-later
// Goes to sleep for good: interrupts are off.
#include <avr/interrupt.h>
#include <avr/sleep.h>

int main(void) {
  cli();
  set_sleep_mode(SLEEP_MODE_IDLE);
  sleep_mode();
  for (;;) *(volatile unsigned char *)0x22 = 1;  // never reached: would show on port A
}
