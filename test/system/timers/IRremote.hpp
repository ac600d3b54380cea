#ifndef _IR_REMOTE_HPP
#define _IR_REMOTE_HPP

#include <Arduino.h>

// Takes a timer as the library IRremote does (4.5): unit A, cleared by it, every 50 µs; timer 2, on a Leonardo 3, unless a sketch
// names another. All of it is in this header.
#if !defined(IR_USE_AVR_TIMER1) && !defined(IR_USE_AVR_TIMER2) && !defined(IR_USE_AVR_TIMER3) && \
    !defined(IR_USE_AVR_TIMER4) && !defined(IR_USE_AVR_TIMER5)
#ifdef __AVR_ATmega32U4__
#define IR_USE_AVR_TIMER3
#else
#define IR_USE_AVR_TIMER2
#endif
#endif

static void sampleInfrared();

#define IR_TAKES_TIMER(number)                           \
  ISR(TIMER##number##_COMPA_vect) { sampleInfrared(); }  \
  static void takeInfraredTimer() {                      \
    TCCR##number##A = 0;                                 \
    TCCR##number##B = _BV(WGM##number##2) | _BV(CS##number##0); \
    OCR##number##A = F_CPU / 20000 - 1;                  \
    TCNT##number = 0;                                    \
    TIMSK##number |= _BV(OCIE##number##A);               \
  }

#if defined(IR_USE_AVR_TIMER1)
IR_TAKES_TIMER(1)
#elif defined(IR_USE_AVR_TIMER3)
IR_TAKES_TIMER(3)
#elif defined(IR_USE_AVR_TIMER4)
IR_TAKES_TIMER(4)
#elif defined(IR_USE_AVR_TIMER5)
IR_TAKES_TIMER(5)
#else
ISR(TIMER2_COMPA_vect) { sampleInfrared(); }
static void takeInfraredTimer() {
  TCCR2A = _BV(WGM21);
  TCCR2B = _BV(CS21);
  OCR2A = F_CPU / 8 / 20000 - 1;
  TCNT2 = 0;
  TIMSK2 |= _BV(OCIE2A);
}
#endif

static void (*infraredSampled)();
static void sampleInfrared() { infraredSampled(); }

#endif
