// SPDX-License-Identifier: GPL-3.0-or-later
// Sends one radio packet again and again on digital pin 12 (B6) at 2000 bit/s: first after START_MS
// milliseconds, then 250 ms after the end of each.
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <util/delay.h>

#ifndef START_MS
#define START_MS 50
#endif

// "////CAFEAwHello!", the example of SPEC section 2, as section 6 sends it.
static const char BITS[] PROGMEM =
    "010101010101010101010101010101010101000111001101011100101010110010001011110010001011"
    "110010001011110010001011011010101010011010011100011010010110011010100110011010011100"
    "001110001110011010110001010110100110010110010101010110010101010110001011110010011100"
    "011010110010110001011010";

static void carrier(char on) {
  if (on)
    PORTB |= _BV(PB6);
  else
    PORTB &= (uint8_t)~_BV(PB6);
}

int main(void) {
  DDRB |= _BV(PB6);
  _delay_ms(START_MS);
  for (;;) {
    for (const char *bit = BITS; pgm_read_byte(bit); bit++) {
      carrier(pgm_read_byte(bit) == '1');
      _delay_us(499);  // the loop takes the rest of the 500
    }
    carrier(0);
    _delay_ms(250);
  }
}
