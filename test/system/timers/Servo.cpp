#include <Arduino.h>

#include "Servo.h"

static const uint8_t SERVOS_PER_TIMER = 12;
static const uint16_t TICKS_A_MICRO = F_CPU / 8000000;
static const uint16_t PERIOD = 20000 * TICKS_A_MICRO;
static const uint16_t PULSE = 1500 * TICKS_A_MICRO;

#ifdef __AVR_ATmega2560__
static const uint8_t TIMERS = 4;
#else
static const uint8_t TIMERS = 1;
#endif

static uint8_t pins[TIMERS * SERVOS_PER_TIMER];
static uint8_t servos;
static int8_t current[TIMERS];  // the servo of a timer whose pulse lasts, -1 behind the last

static uint8_t *pinOf(uint8_t timer) {
  const uint8_t index = timer * SERVOS_PER_TIMER + current[timer];
  return current[timer] < SERVOS_PER_TIMER && index < servos ? &pins[index] : nullptr;
}

static void next(uint8_t timer, volatile uint16_t &count, volatile uint16_t &alarm) {
  if (current[timer] < 0) {
    count = 0;
  } else if (pinOf(timer) && *pinOf(timer)) {
    digitalWrite(*pinOf(timer), LOW);
  }
  current[timer]++;
  if (pinOf(timer)) {
    alarm = count + PULSE;
    if (*pinOf(timer)) digitalWrite(*pinOf(timer), HIGH);
  } else {
    alarm = count + 4 < PERIOD ? PERIOD : count + 4;
    current[timer] = -1;
  }
}

#ifdef __AVR_ATmega2560__
ISR(TIMER5_COMPA_vect) { next(0, TCNT5, OCR5A); }
ISR(TIMER1_COMPA_vect) { next(1, TCNT1, OCR1A); }
ISR(TIMER3_COMPA_vect) { next(2, TCNT3, OCR3A); }
ISR(TIMER4_COMPA_vect) { next(3, TCNT4, OCR4A); }
#else
ISR(TIMER1_COMPA_vect) { next(0, TCNT1, OCR1A); }
#endif

static void take(uint8_t timer) {
#ifdef __AVR_ATmega2560__
  switch (timer) {
    case 0:
      TCCR5A = 0;
      TCCR5B = _BV(CS51);
      TCNT5 = 0;
      TIFR5 = _BV(OCF5A);
      TIMSK5 = _BV(OCIE5A);
      return;
    case 2:
      TCCR3A = 0;
      TCCR3B = _BV(CS31);
      TCNT3 = 0;
      TIFR3 = _BV(OCF3A);
      TIMSK3 = _BV(OCIE3A);
      return;
    case 3:
      TCCR4A = 0;
      TCCR4B = _BV(CS41);
      TCNT4 = 0;
      TIFR4 = _BV(OCF4A);
      TIMSK4 = _BV(OCIE4A);
      return;
  }
#else
  (void)timer;
#endif
  TCCR1A = 0;
  TCCR1B = _BV(CS11);
  TCNT1 = 0;
  TIFR1 |= _BV(OCF1A);
  TIMSK1 |= _BV(OCIE1A);
}

Servo::Servo() : index_(servos++) {}

void Servo::attach(int pin) {
  pinMode(pin, OUTPUT);
  pins[index_] = pin;
  if (index_ % SERVOS_PER_TIMER == 0) take(index_ / SERVOS_PER_TIMER);
}
