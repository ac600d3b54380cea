// SPDX-License-Identifier: GPL-3.0-or-later
// Gives a packet of SPEC 6.2 to a module at UART 1 each 300 ms, from START_MS on, with BYTES bytes of 'x' before it.
#include <avr/io.h>
#include <util/delay.h>

#ifndef START_MS
#define START_MS 50
#endif
#ifndef BYTES
#define BYTES 0
#endif
#ifndef BAUD_RATE
#define BAUD_RATE 9600
#endif

static const uint8_t PACKET[] = "\0\x01\x13////CAFEAwHello!\xb2\xbc";  // with the 0 that ends it

static void put(uint8_t byte) {
  while (!(UCSR1A & _BV(UDRE1))) {
  }
  UDR1 = byte;
}

int main(void) {
  UCSR1A = _BV(U2X1);
  UBRR1 = F_CPU / 8 / BAUD_RATE - 1;
  UCSR1B = _BV(TXEN1);
  _delay_ms(START_MS);
  for (;;) {
    for (int i = 0; i < BYTES; i++) put('x');
    for (unsigned i = 0; i < sizeof PACKET; i++) put(PACKET[i]);
    _delay_ms(300);
  }
}
