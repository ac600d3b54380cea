#include <Arduino.h>

#include "TimerOne.h"

TimerOne Timer1;
static void (*callback)();

ISR(TIMER1_OVF_vect) { callback(); }

void TimerOne::initialize(unsigned long micros) {
  // The library's own mode of PWM, 8, is none of simavr's.
  TCCR1B = _BV(WGM13) | _BV(WGM12);
  TCCR1A = _BV(WGM11);
  ICR1 = F_CPU / 8000000 * micros - 1;
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS11);
}

void TimerOne::attachInterrupt(void (*function)()) {
  callback = function;
  TIMSK1 = _BV(TOIE1);
}
