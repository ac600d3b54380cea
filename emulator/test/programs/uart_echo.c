// SPDX-License-Identifier: GPL-3.0-or-later
// Sends back each byte that comes on UART 0, at 115200 baud; sleeps in between.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

ISR(USART0_RX_vect) { UDR0 = UDR0; }

int main(void) {
  UCSR0A = _BV(U2X0);
  UBRR0 = F_CPU / 8 / 115200;
  UCSR0B = _BV(RXEN0) | _BV(TXEN0) | _BV(RXCIE0);
  set_sleep_mode(SLEEP_MODE_IDLE);
  sei();
  for (;;) sleep_mode();
}
