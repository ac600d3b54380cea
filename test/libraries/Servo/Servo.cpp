#include "Servo.h"

#include <Arduino.h>

static const uint16_t PERIOD_MICROS = 20000;
static const uint16_t LEAST_MICROS = 544;
static const uint16_t MOST_MICROS = 2400;

static uint8_t pulsePin;
static volatile uint16_t pulseMicros = 1500;

// The timer counts at an eighth of the CPU's clock.
static uint16_t ticks(uint16_t micros) { return micros * (F_CPU / 8000000L); }

ISR(TIMER1_COMPA_vect) {
  if (digitalRead(pulsePin)) {
    digitalWrite(pulsePin, LOW);
    OCR1A = ticks(PERIOD_MICROS);
  } else {
    TCNT1 = 0;
    OCR1A = ticks(pulseMicros);
    digitalWrite(pulsePin, HIGH);
  }
}

uint8_t Servo::attach(int pin) {
  pulsePin = static_cast<uint8_t>(pin);
  pinMode(pulsePin, OUTPUT);
  TCCR1A = 0;
  TCCR1B = _BV(CS11);
  OCR1A = ticks(PERIOD_MICROS);
  TIMSK1 |= _BV(OCIE1A);
  return 0;
}

void Servo::write(int degrees) {
  const uint16_t micros =
      static_cast<uint16_t>(LEAST_MICROS + static_cast<long>(MOST_MICROS - LEAST_MICROS) * degrees / 180);
  noInterrupts();
  pulseMicros = micros;
  interrupts();
}
