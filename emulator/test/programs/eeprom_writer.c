// SPDX-License-Identifier: GPL-3.0-or-later
// Prints at each start how many of 256 bytes, which no start-up code clears, it finds as it left them,
// and whether the EEPROM is busy. Then it writes 0x55 to EEPROM byte 0, 1, … and rests 5 ms after each;
// digital pin 13 (B7) is high while it writes.
#include <avr/eeprom.h>
#include <avr/io.h>
#include <stdio.h>
#include <util/delay.h>

#include "print.h"

#define LEFT 0xA5

static volatile uint8_t kept[256] __attribute__((section(".noinit")));

int main(void) {
  char line[32];
  uint8_t busy = !eeprom_is_ready();
  int same = 0;
  for (int i = 0; i < 256; i++) {
    same += kept[i] == LEFT;
    kept[i] = LEFT;
  }
  UCSR0A = _BV(U2X0);
  UBRR0 = F_CPU / 8 / 115200;
  UCSR0B = _BV(TXEN0);
  snprintf(line, sizeof line, "kept %d%s\n", same, busy ? " busy" : "");
  print(line);
  DDRB |= _BV(PB7);
  eeprom_busy_wait();
  for (uint16_t address = 0; address <= E2END; address++) {
    PORTB |= _BV(PB7);
    eeprom_write_byte((uint8_t *)address, 0x55);
    eeprom_busy_wait();
    PORTB &= (uint8_t)~_BV(PB7);
    _delay_ms(5);
  }
  for (;;) {
  }
}
