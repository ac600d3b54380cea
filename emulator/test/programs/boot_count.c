// SPDX-License-Identifier: GPL-3.0-or-later
// Counts its starts in EEPROM byte 0 and prints the count.
#include <avr/eeprom.h>
#include <avr/io.h>

int main(void) {
  uint8_t count = (uint8_t)(eeprom_read_byte((uint8_t *)0) + 1);
  eeprom_write_byte((uint8_t *)0, count);
  UBRR0 = F_CPU / 16 / 9600 - 1;
  UCSR0B = _BV(TXEN0);
  while (!(UCSR0A & _BV(UDRE0))) {
  }
  UDR0 = (uint8_t)('0' + count);
  while (!(UCSR0A & _BV(UDRE0))) {
  }
  UDR0 = '\n';
  for (;;) {
  }
}
