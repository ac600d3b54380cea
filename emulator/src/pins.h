// SPDX-License-Identifier: GPL-3.0-or-later
// Which AVR port bit is behind which digital pin of an Arduino Mega 2560.
#ifndef JAVINO_PINS_H
#define JAVINO_PINS_H

#define PIN_COUNT 70
#define PIN_A0 54
// The simulated converter takes values for its first eight channels only.
#define ADC_CHANNELS 8

typedef struct {
    char port; // 'A'…'L' without 'I'
    int bit;   // 0…7
} pin_location;

// Where `pin`, 0…69, is on the chip.
pin_location pin_locate(int pin);

// The pin at a port bit, or -1 where the Mega brings none out.
int pin_at(char port, int bit);

// Reads "0"…"69" or "A0"…"A15". Returns the pin, or -1.
int pin_parse(const char *text);

#endif
