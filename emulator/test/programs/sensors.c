// SPDX-License-Identifier: GPL-3.0-or-later
// Every 100 ms prints "cm LIGHT BUTTON": an HC-SR04 on trigger 22 (A0) and echo 2 (E4), a light
// sensor on analog pin A0, a button on 40 (G1). Digital pin 5 (E3) goes high after 500 ms.
#include <avr/io.h>
#include <stdio.h>
#include <util/delay.h>

static int put(char c, FILE *stream) {
  (void)stream;
  while (!(UCSR0A & _BV(UDRE0))) {
  }
  UDR0 = (uint8_t)c;
  return 0;
}

static FILE output = FDEV_SETUP_STREAM(put, NULL, _FDEV_SETUP_WRITE);

// Length of the echo in microseconds, by timer 1 at 2 MHz.
static uint16_t measure_echo(void) {
  PORTA |= _BV(PA0);
  _delay_us(12);
  PORTA &= (uint8_t)~_BV(PA0);
  while (!(PINE & _BV(PE4))) {
  }
  TCNT1 = 0;
  while (PINE & _BV(PE4)) {
  }
  return TCNT1 / 2;
}

static uint16_t read_light(void) {
  ADMUX = _BV(REFS0);
  ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
  while (ADCSRA & _BV(ADSC)) {
  }
  return ADC;
}

int main(void) {
  UBRR0 = F_CPU / 16 / 9600 - 1;
  UCSR0B = _BV(TXEN0);
  DDRA |= _BV(PA0);
  DDRE |= _BV(PE3);
  PORTG |= _BV(PG1);  // pull-up: the button pulls it down
  TCCR1B = _BV(CS11);
  stdout = &output;
  for (uint8_t round = 0;; round++) {
    _delay_ms(100);
    if (round == 4) PORTE |= _BV(PE3);
    printf("%u %u %u\n", measure_echo() / 58, read_light(), (PING >> PG1) & 1);
  }
}
