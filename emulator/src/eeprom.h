// SPDX-License-Identifier: GPL-3.0-or-later
// The chip's EEPROM with the times of a real one: simavr's own writes take none.
#ifndef JAVINO_EEPROM_H
#define JAVINO_EEPROM_H

#include <stdint.h>

#include "clock.h"
#include "prng.h"

struct avr_t;
struct avr_eeprom_t;

// ATmega640/1280/2560 datasheet, table 8-1: EEPM = 0, and EEPM = 1 or 2. An oscillator of its own makes it the same at any
// clock.
#define EEPROM_WRITE_US 3400
#define EEPROM_SPLIT_US 1800

typedef struct {
  void *context;
  // The program has begun to write a byte.
  void (*written)(void *context, uint16_t address, uint8_t byte);
} eeprom_listener;

typedef struct {
  struct avr_t *avr;
  struct avr_eeprom_t *part;  // simavr's, with the bytes
  eeprom_listener listener;
  uint64_t done_at;  // when the write under way ends, in the chip's cycles; 0 while there is none
  uint16_t address;  // of the write under way
  uint8_t before;    // what was there
  uint8_t mode;      // EEPM
  uint64_t writes;   // bytes that the program has written
} eeprom;

// Takes the place of simavr's control register.
void eeprom_init(eeprom *e, struct avr_t *avr, eeprom_listener listener);

// The chip holds these bytes from now on: as many as it has.
void eeprom_load(eeprom *e, const uint8_t *bytes);

// The chip was reset: a write under way goes on, as it does in a real chip.
void eeprom_reset(eeprom *e);

// The power is gone: leaves the byte that is being written old, half erased, erased or half written.
// Returns its address, or -1 when none was.
int eeprom_tear(eeprom *e, prng *noise);

#endif
