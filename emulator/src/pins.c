// SPDX-License-Identifier: GPL-3.0-or-later
#include "pins.h"

#include <stdlib.h>
#include <string.h>

// The simulated converter takes values for its first eight channels only.
#define ADC_CHANNELS 8

pin_location pin_locate(const model *m, int pin) {
  return (pin_location){m->locations[2 * pin], m->locations[2 * pin + 1] - '0'};
}

int pin_at(const model *m, char port, int bit) {
  for (int pin = 0; pin < m->pin_count; pin++) {
    pin_location location = pin_locate(m, pin);
    if (location.port == port && location.bit == bit) return pin;
  }
  return -1;
}

int pin_parse(const model *m, const char *text) {
  int base = 0;
  int limit = m->pin_count;
  if (*text == 'A') {
    text++;
    base = m->pin_a0;
    limit = m->pin_count - m->pin_a0;
  }
  size_t digits = strspn(text, "0123456789");
  if (digits < 1 || digits > 2 || text[digits] != '\0') return -1;
  int number = atoi(text);
  return number < limit ? base + number : -1;
}

bool pin_is_analog(const model *m, int pin) {
  return pin >= m->pin_a0 && pin < m->pin_count && pin < m->pin_a0 + ADC_CHANNELS;
}
