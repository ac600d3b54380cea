// SPDX-License-Identifier: GPL-3.0-or-later
// Tells trace points, and writes to the EEPROM between them.
#include <avr/eeprom.h>
#include <avr/io.h>
#include <util/delay.h>

enum {
  NO_POINT,
#define POINT(name, first, second) name,
#include "TracePoints.h"
#undef POINT
};

static void tell(uint8_t point, uint8_t first, uint8_t second) {
  GPIOR2 = second;
  GPIOR1 = first;
  GPIOR0 = point;
}

static void write(uint8_t at, uint8_t count) {
  while (count--) eeprom_write_byte((uint8_t *)(uint16_t)at, at), at++;
  eeprom_busy_wait();
}

int main(void) {
  write(10, 6);
  tell(EPOCH_STORED, 7, 0);
  write(100, 30);
  for (uint8_t i = 0; i < 10; i++, _delay_ms(1)) tell(i < 5 ? QUIET : BUSY, 0, 0);
  _delay_ms(4);
  tell(BUSY, 0, 0);
  for (uint8_t i = 0; i < 3; i++) tell(TURN, 3, 0);
  tell(FLOOR_STORED, 4, 9);
  tell(255, 0, 0);
  write(200, 1);
  for (;;) {
  }
}
