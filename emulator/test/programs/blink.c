// SPDX-License-Identifier: GPL-3.0-or-later
// Toggles digital pin 13 (B7 of a Mega, B5 of an Uno) every 10 ms, asleep in between; prints a line at the start.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include "print.h"

#ifdef __AVR_ATmega328P__
#define LED PB5
#else
#define LED PB7
#endif

ISR(TIMER1_COMPA_vect) { PORTB ^= _BV(LED); }

int main(void) {
  UBRR0 = F_CPU / 16 / 9600 - 1;
  UCSR0B = _BV(TXEN0);
  DDRB |= _BV(LED);
  TCCR1B = _BV(WGM12) | _BV(CS11);  // CTC, F_CPU / 8
  OCR1A = F_CPU / 8 / 100 - 1;
  TIMSK1 = _BV(OCIE1A);
  set_sleep_mode(SLEEP_MODE_IDLE);
  sei();
  print("blink\n");
  for (;;) sleep_mode();
}
