// SPDX-License-Identifier: GPL-3.0-or-later
// Gives two pins of a Mega a duty as analogWrite() does: 11 (B5) by timer 1 in phase-correct mode, 4 (G5) by timer 0 in
// fast mode; 10 ms later one pin is high by the program, and the other inverted.
#include <avr/io.h>
#include <util/delay.h>

int main(void) {
  DDRB |= _BV(PB5);
  DDRG |= _BV(PG5);
  TCCR1A = _BV(WGM10);
  TCCR1B = _BV(CS11) | _BV(CS10);
  TCCR0A = _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(CS01) | _BV(CS00);
  TCCR1A |= _BV(COM1A1);
  OCR1A = 51;
  TCCR0A |= _BV(COM0B1);
  OCR0B = 204;
  _delay_ms(10);
  TCCR0A |= _BV(COM0B0);
  TCCR1A &= (uint8_t)~_BV(COM1A1);
  PORTB |= _BV(PB5);
  for (;;) {
  }
}
