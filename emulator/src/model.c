// SPDX-License-Identifier: GPL-3.0-or-later
#include "model.h"

#include <stdlib.h>
#include <string.h>

// The simulated converter takes values for its first eight channels only.
#define ADC_CHANNELS 8

#define EICRA 0x69
#define EICRB 0x6A
// The bits of some vectors in a row.
#define VECTORS(first, last) ((2ull << (last)) - (1ull << (first)))

const model MEGA = {
    .name = "mega",
    .chip = "ATmega2560",
    .mcu = "atmega2560",
    .family = 6,  // with a program counter of 22 bits
    .clock_cycles = 1,
    .supply_mv = 5000,
    .eeprom_size = 4096,
    .boot_size = 8192,
    .pin_count = 70,
    .pin_a0 = 54,
    // Arduino Mega 2560 schematic, revision 3.
    .locations =
        "E0E1E4E5G5E3H3H4H5H6"  //  0…9
        "B4B5B6B7J1J0H1H0D3D2"  // 10…19
        "D1D0A0A1A2A3A4A5A6A7"  // 20…29
        "C7C6C5C4C3C2C1C0D7G2"  // 30…39
        "G1G0L7L6L5L4L3L2L1L0"  // 40…49
        "B3B2B1B0"              // 50…53
        "F0F1F2F3F4F5F6F7"      // A0…A7
        "K0K1K2K3K4K5K6K7",     // A8…A15
    .pins = "0…69 or \"A0\"…\"A15\"",
    .adc_pins = "\"A0\"…\"A7\"",
    // INT0 to INT3, PCINT0 to PCINT2, WDT, TWI; ADC, EE_READY, SPM_READY; INT4 to INT7.
    .wakes = {.always = VECTORS(1, 4) | VECTORS(9, 12) | VECTORS(39, 39),
              .adc_noise_reduction = VECTORS(29, 30) | VECTORS(40, 40),
              .timer_2 = VECTORS(13, 15),
              .level_first = 5,
              .level_count = 4,
              .level_control = EICRB},
};

// The part that all boards with this chip have alike; pins as in the Arduino Uno schematic, revision 3. A Pro Mini's A6
// and A7 go to the converter alone, and are left out.
#define ATMEGA328P                                                                                                 \
  .chip = "ATmega328P", .mcu = "atmega328p", .family = 5, .eeprom_size = 1024, .boot_size = 4096, .pin_count = 20, \
  .pin_a0 = 14,                                                                                                    \
  .locations =                                                                                                     \
      "D0D1D2D3D4D5D6D7" /* 0 to 7 */                                                                              \
      "B0B1B2B3B4B5"     /* 8 to 13 */                                                                             \
      "C0C1C2C3C4C5",    /* A0 to A5 */                                                                            \
      .pins = "0…19 or \"A0\"…\"A5\"",                                                                             \
  .adc_pins = "\"A0\"…\"A5\"", /* PCINT0 to PCINT2, WDT, TWI; ADC, EE_READY, SPM_READY; INT0 and INT1. */          \
      .wakes = {.always = VECTORS(3, 6) | VECTORS(24, 24),                                                         \
                .adc_noise_reduction = VECTORS(21, 22) | VECTORS(25, 25),                                          \
                .timer_2 = VECTORS(7, 9),                                                                          \
                .level_first = 1,                                                                                  \
                .level_count = 2,                                                                                  \
                .level_control = EICRA}

const model UNO = {.name = "uno", .clock_cycles = 1, .supply_mv = 5000, ATMEGA328P};

const model PRO_MINI = {.name = "promini", .clock_cycles = 2, .supply_mv = 3300, ATMEGA328P};

static const model *const MODELS[] = {&MEGA, &UNO, &PRO_MINI};

const char *const MODEL_NAMES[] = {"mega", "uno", "promini", NULL};

const model *model_at(int index) { return MODELS[index]; }

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
