// SPDX-License-Identifier: GPL-3.0-or-later
// Text on UART 0, whose rate and transmitter the program has set.
#pragma once
#include <avr/io.h>

static void print(const char *text) {
  for (; *text; text++) {
    while (!(UCSR0A & _BV(UDRE0))) {
    }
    UDR0 = (uint8_t)*text;
  }
}
