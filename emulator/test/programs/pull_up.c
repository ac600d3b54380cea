// SPDX-License-Identifier: GPL-3.0-or-later
// Says whether digital pin 2 (E4 of a Mega), which is pulled up, is high.
#include <avr/io.h>
#include <avr/sleep.h>

#include "print.h"

int main(void) {
  UBRR0 = F_CPU / 16 / 9600 - 1;
  UCSR0B = _BV(TXEN0);
  PORTE |= _BV(PE4);
  print(PINE & _BV(PE4) ? "high\n" : "low\n");
  for (;;) sleep_mode();
}
