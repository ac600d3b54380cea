#include <Arduino.h>

#include "NewPing.h"

static unsigned long every, left;
static void (*callback)();

static void count() {
  if (--left != 0) return;
  left = every;
  callback();
}

#ifdef __AVR_ATmega32U4__
ISR(TIMER4_OVF_vect) { count(); }
#else
ISR(TIMER2_COMPA_vect) { count(); }
#endif

void NewPing::timer_ms(unsigned long millis, void (*function)()) {
  every = left = millis;
  callback = function;
#ifdef __AVR_ATmega32U4__
  TIMSK4 = 0;
  TCCR4A = TCCR4C = TCCR4D = TCCR4E = 0;
  TCCR4B = _BV(CS42) | _BV(CS41) | _BV(CS40) | _BV(PSR4);
  TIFR4 = _BV(TOV4);
  TCNT4 = 0;
  OCR4C = 249;
  TIMSK4 = _BV(TOIE4);
#else
  TIMSK2 &= ~_BV(OCIE2A);
  ASSR &= ~_BV(AS2);
  TCCR2A = _BV(WGM21);
  TCCR2B = _BV(CS22);
  TCNT2 = 0;
  OCR2A = 249;
  TIMSK2 |= _BV(OCIE2A);
#endif
}
