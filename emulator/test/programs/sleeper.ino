// SPDX-License-Identifier: GPL-3.0-or-later
// Sleeps in the mode MODE, again and again, and says on its pins what has woken it.
#include <avr/sleep.h>
#include <avr/wdt.h>

const uint8_t AWAKE = 13;      // changes whenever the chip wakes
const uint8_t TIME_WENT = 12;  // whether micros() went on meanwhile
const uint8_t HEARD = 10;      // changes with each byte from the host
const uint8_t WOKEN = 9;       // changes with each interrupt of the pins 2 and 21, or of the converter

static void woken() { digitalWrite(WOKEN, !digitalRead(WOKEN)); }

ISR(WDT_vect) {}
#ifdef CONVERTER
ISR(ADC_vect) { woken(); }
#endif

void setup() {
  const uint8_t outputs[] = {AWAKE, TIME_WENT, HEARD, WOKEN};
  for (uint8_t pin : outputs) pinMode(pin, OUTPUT);
#ifndef DEAF
  Serial.begin(115200);
#endif
#ifdef GREETS
  Serial.print('z');
  Serial.flush();
#endif
  set_sleep_mode(MODE);
#ifdef WATCHDOG
  // An interrupt every 0.128 s, the 16384 cycles of an oscillator of 128 kHz.
  cli();
  wdt_reset();
  WDTCSR = _BV(WDCE) | _BV(WDE);
  WDTCSR = _BV(WDIE) | _BV(WDP1) | _BV(WDP0);
  sei();
#endif
#ifdef CONVERTER
  ADCSRA |= _BV(ADIE);
#endif
#ifdef EVENT
  const uint8_t inputs[] = {2, 21};
  for (uint8_t pin : inputs) {
    if (digitalPinToInterrupt(pin) == NOT_AN_INTERRUPT) continue;
    pinMode(pin, INPUT_PULLUP);
    attachInterrupt(digitalPinToInterrupt(pin), woken, EVENT);
  }
#endif
}

void loop() {
  const unsigned long before = micros();
#ifdef DISABLED
  sleep_cpu();
#else
  sleep_mode();
#endif
  digitalWrite(TIME_WENT, micros() - before > 500);
  digitalWrite(AWAKE, !digitalRead(AWAKE));
  for (; Serial.available() > 0; Serial.read()) digitalWrite(HEARD, !digitalRead(HEARD));
}
