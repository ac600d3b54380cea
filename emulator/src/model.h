// SPDX-License-Identifier: GPL-3.0-or-later
// The Arduinos that can be emulated, and all that tells one from another.
#ifndef JAVINO_MODEL_H
#define JAVINO_MODEL_H

#include <stdbool.h>
#include <stdint.h>

// Interrupts that wake the chip from a sleep mode in which clocks stop: bits by vector, as in avr-libc.
typedef struct {
  uint64_t always;                   // pins, the bus's address match, the watchdog
  uint64_t adc_noise_reduction;      // in that mode also the converter's, and those for EEPROM and flash
  uint64_t timer_2;                  // where it has its own crystal
  uint8_t level_first, level_count;  // external interrupts of which only the level is seen: an edge needs a clock
  uint16_t level_control;            // EICRx, with two bits for each of these
} model_wakes;

typedef struct {
  const char *name;       // in a scenario
  const char *chip;       // as its data sheet writes it
  const char *mcu;        // the same, as compiler and simavr write it
  unsigned family;        // the low bits of its ELF files' flags (binutils, include/elf/avr.h)
  unsigned clock_cycles;  // of 16 MHz that a cycle of the board takes
  double supply_mv;       // of the chip, and the converter's reference
  int eeprom_size;        // bytes
  unsigned boot_size;     // bytes at the end of the flash where a boot loader may lie
  int pin_count;          // digital pins, the analog ones among them
  int pin_a0;             // they begin with this one
  const char *locations;  // two characters a pin: port and bit
  const char *pins;       // all of them, in words
  const char *adc_pins;   // those of the first eight channels, which are all that simavr takes values for
  model_wakes wakes;
} model;

extern const model MEGA, UNO, PRO_MINI;

// "mega", "uno", "promini", NULL: what json_choice takes.
extern const char *const MODEL_NAMES[];

// The model whose name is the index-th.
const model *model_at(int index);

// The port bit of the chip that is behind a digital pin.
typedef struct {
  char port;  // 'A'…'L' without 'I'
  int bit;    // 0…7
} pin_location;

// The place of `pin`, one of the model's, on the chip.
pin_location pin_locate(const model *m, int pin);

// The pin at a port bit, or -1 where the model brings none out.
int pin_at(const model *m, char port, int bit);

// Reads a number or "A0" and so on. Returns the pin, or -1 where the model has none of this name.
int pin_parse(const model *m, const char *text);

// Whether the simulated converter takes values for the pin.
bool pin_is_analog(const model *m, int pin);

#endif
