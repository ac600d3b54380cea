// SPDX-License-Identifier: GPL-3.0-or-later
#include "pins.h"

#include <stdlib.h>
#include <string.h>

// Two characters a pin: port and bit (Arduino Mega 2560 schematic, revision 3).
static const char LOCATIONS[] =
    "E0E1E4E5G5E3H3H4H5H6" //  0…9
    "B4B5B6B7J1J0H1H0D3D2" // 10…19
    "D1D0A0A1A2A3A4A5A6A7" // 20…29
    "C7C6C5C4C3C2C1C0D7G2" // 30…39
    "G1G0L7L6L5L4L3L2L1L0" // 40…49
    "B3B2B1B0"             // 50…53
    "F0F1F2F3F4F5F6F7"     // A0…A7
    "K0K1K2K3K4K5K6K7";    // A8…A15

_Static_assert(sizeof LOCATIONS == 2 * PIN_COUNT + 1, "one location for each pin");

pin_location pin_locate(int pin)
{
    return (pin_location){LOCATIONS[2 * pin], LOCATIONS[2 * pin + 1] - '0'};
}

int pin_at(char port, int bit)
{
    for (int pin = 0; pin < PIN_COUNT; pin++) {
        pin_location location = pin_locate(pin);
        if (location.port == port && location.bit == bit)
            return pin;
    }
    return -1;
}

int pin_parse(const char *text)
{
    int base = 0;
    int limit = PIN_COUNT;
    if (*text == 'A') {
        text++;
        base = PIN_A0;
        limit = PIN_COUNT - PIN_A0;
    }
    size_t digits = strspn(text, "0123456789");
    if (digits < 1 || digits > 2 || text[digits] != '\0')
        return -1;
    int number = atoi(text);
    return number < limit ? base + number : -1;
}
