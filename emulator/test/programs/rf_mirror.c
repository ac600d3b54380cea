// SPDX-License-Identifier: GPL-3.0-or-later
// Copies the level of the radio's RX pin, digital 11 (B5), to digital pin 5 (E3).
#include <avr/io.h>

int main(void) {
  DDRE |= _BV(PE3);
  for (;;) {
    if (PINB & _BV(PB5))
      PORTE |= _BV(PE3);
    else
      PORTE &= (uint8_t)~_BV(PE3);
  }
}
