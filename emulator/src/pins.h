// SPDX-License-Identifier: GPL-3.0-or-later
// Which AVR port bit is behind which digital pin of an Arduino.
#ifndef JAVINO_PINS_H
#define JAVINO_PINS_H

#include <stdbool.h>

#include "model.h"

typedef struct {
  char port;  // 'A'…'L' without 'I'
  int bit;    // 0…7
} pin_location;

// Where `pin`, one of the model's, is on the chip.
pin_location pin_locate(const model *m, int pin);

// The pin at a port bit, or -1 where the model brings none out.
int pin_at(const model *m, char port, int bit);

// Reads a number or "A0" and so on. Returns the pin, or -1 where the model has none of this name.
int pin_parse(const model *m, const char *text);

// Whether the simulated converter takes values for the pin.
bool pin_is_analog(const model *m, int pin);

#endif
