// SPDX-License-Identifier: GPL-3.0-or-later
// Has in it what tells simavr to write a trace of an I/O register to a file, and blinks; keeps a byte in the EEPROM.
#include <avr/eeprom.h>
#include <avr/io.h>
#include <avr/avr_mcu_section.h>
#include <util/delay.h>

#include "print.h"

AVR_MCU(F_CPU, "atmega2560");
AVR_MCU_VCD_FILE("stolen.vcd", 1000);

const struct avr_mmcu_vcd_trace_t traces[] _MMCU_ = {
    {AVR_MCU_VCD_SYMBOL("PORTB"), .what = (void *)&PORTB},
};

uint8_t kept EEMEM = 0x5A;

int main(void) {
  DDRB = 0xFF;
  UBRR0 = F_CPU / 16 / 9600 - 1;
  UCSR0B = _BV(TXEN0);
  print(eeprom_read_byte(&kept) == 0x5A ? "kept\n" : "lost\n");
  for (;;) {
    PINB = 0x80;
    _delay_ms(1);
  }
}
