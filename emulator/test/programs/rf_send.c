// SPDX-License-Identifier: GPL-3.0-or-later
// Sends a radio packet with the payload "////CAFEAwHello!" (SPEC section 6) on digital pin 12 (B6)
// at 2000 bit/s, every 200 ms. The bits come from the table that the test's encoder has made.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <util/delay.h>

#include "hello_bits.h"

int main(void)
{
    DDRB |= _BV(PB6);
    _delay_ms(50);
    for (;;) {
        for (uint16_t i = 0; i < HELLO_BITS; i++) {
            if (pgm_read_byte(&hello_bits[i]) == '1')
                PORTB |= _BV(PB6);
            else
                PORTB &= (uint8_t)~_BV(PB6);
            _delay_us(499);
        }
        PORTB &= (uint8_t)~_BV(PB6);
        _delay_ms(200);
    }
}
