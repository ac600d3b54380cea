// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how many microseconds each way of writing an EEPROM byte takes, and what is there then.
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <stdio.h>

static int put(char c, FILE *stream) {
  (void)stream;
  while (!(UCSR0A & _BV(UDRE0))) {
  }
  UDR0 = (uint8_t)c;
  return 0;
}

static FILE output = FDEV_SETUP_STREAM(put, NULL, _FDEV_SETUP_WRITE);

static volatile uint8_t interrupts;

// Writes 1, 2 and 3 to the bytes 10, 11 and 12.
ISR(EE_READY_vect) {
  if (interrupts == 3) {
    EECR &= (uint8_t)~_BV(EERIE);
  } else {
    EEAR = 10 + interrupts;
    EEDR = interrupts + 1;
    EECR |= _BV(EEMPE);
    EECR |= _BV(EEPE);
  }
  interrupts++;
}

static void start(uint8_t mode, uint16_t address, uint8_t value) {
  EECR = mode;
  EEAR = address;
  EEDR = value;
  EECR |= _BV(EEMPE);
  EECR |= _BV(EEPE);
}

// Waits for the end of the write and prints its name, its time and what byte 0 holds.
static void report(const char *name) {
  eeprom_busy_wait();
  uint16_t time = TCNT1;
  EECR = 0;
  printf("%s %u %02x\n", name, time / 2, eeprom_read_byte((uint8_t *)0));
}

int main(void) {
  UCSR0A = _BV(U2X0);
  UBRR0 = F_CPU / 8 / 115200;
  UCSR0B = _BV(TXEN0);
  TCCR1B = _BV(CS11);  // 2 MHz
  stdout = &output;

  TCNT1 = 0, start(0, 0, 0x0F), report("write");
  TCNT1 = 0, start(_BV(EEPM1), 0, 0x3C), report("write-only");
  TCNT1 = 0, start(_BV(EEPM0), 0, 0), report("erase-only");
  TCNT1 = 0, eeprom_update_byte((uint8_t *)0, 0xFF), report("update");
  TCNT1 = 0, start(0, 0, 0x11), start(0, 0, 0x22), report("hasty");

  // EEPE without EEMPE, and EEMPE too long before, write nothing.
  TCNT1 = 0, EEDR = 0x33, EECR = _BV(EEPE), report("unarmed");
  TCNT1 = 0, EECR = _BV(EEMPE);
  __asm__ volatile("nop\nnop\nnop\nnop\nnop");
  EECR |= _BV(EEPE), report("late");

  set_sleep_mode(SLEEP_MODE_IDLE);
  sei();
  TCNT1 = 0, EECR |= _BV(EERIE);
  while (interrupts < 4) sleep_mode();
  report("interrupt");
  printf("%02x %02x %02x\n", eeprom_read_byte((uint8_t *)10), eeprom_read_byte((uint8_t *)11),
         eeprom_read_byte((uint8_t *)12));
  for (;;) sleep_mode();
}
