// SPDX-License-Identifier: GPL-3.0-or-later
// Copies to UART 0 each byte that a module gives to UART 1; sleeps in between.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

ISR(USART1_RX_vect) { UDR0 = UDR1; }

int main(void) {
  UCSR0A = UCSR1A = _BV(U2X0);
  UBRR0 = UBRR1 = F_CPU / 8 / 9600 - 1;
  UCSR0B = _BV(TXEN0);
  UCSR1B = _BV(RXEN1) | _BV(RXCIE1);
  set_sleep_mode(SLEEP_MODE_IDLE);
  sei();
  for (;;) sleep_mode();
}
