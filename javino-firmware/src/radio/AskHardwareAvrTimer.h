#pragma once

/// The timer half of AskHardware.h on an AVR. One source file of a program includes it: AskHardwareAvrTimer.cpp, or, by way
/// of JavinoBDI.h, a sketch that names another timer. Then the linker has no need of AskHardwareAvrTimer.cpp's and leaves it in
/// the library's archive, so that no timer is taken, and no interrupt defined, but the one that is named.
///
/// Of each timer it takes compare unit B, as others' interrupts are mostly on unit A. Two that take one timer do not work: of a
/// timer of 16 bits it defines all interrupts, so that the linker refuses such a program, and takenTimer() finds the others.

#include <Arduino.h>
#include <avr/interrupt.h>

#include "AskHardware.h"
#include "../support/Inlining.h"

/// The timer, by its number: 1; on a Leonardo 1 or 3; on a Mega 1, 3, 4 or 5; or 0, which goes on to run millis(). The
/// PWM of its pins is lost.
#ifndef JAVINO_RADIO_TIMER
#define JAVINO_RADIO_TIMER 1
#endif

#if JAVINO_RADIO_TIMER != 0 && JAVINO_RADIO_TIMER != 1 && !(JAVINO_RADIO_TIMER == 3 && defined(OCR3BL)) && \
    !(JAVINO_RADIO_TIMER == 4 && defined(OCR4BL)) && !(JAVINO_RADIO_TIMER == 5 && defined(OCR5BL))
#error "JAVINO_RADIO_TIMER: this chip has no such timer; 0 and 1 always will do, on a Leonardo 3, on a Mega 3, 4 and 5"
#endif

namespace javinolib {
namespace askhardware {

/// Starts the timer. What another part of the sketch has set stays as it is.
void beginTimer();

/// Interrupt: the alarm's time has come.
void onAlarm();

}  // namespace askhardware
}  // namespace javinolib

#define JAVINO_TAKEN_TIMER ((JAVINO_RADIO_TIMER + 1) << 4)

#if JAVINO_RADIO_TIMER == 0

// Timer 0 counts to 255 at a 64th of the CPU's clock (4 µs at 16 MHz); micros() counts its rounds. The core has it in a mode
// of PWM, in which a new alarm would wait for the next round: here it runs freely, at the same rate.

namespace {

const uint8_t PRESCALER = 64;
volatile uint16_t alarmAt;  // the interrupt comes in each round, one from before may too: what is not due is no alarm

}  // namespace

ISR(TIMER0_COMPB_vect) {
  if (static_cast<int16_t>(javinolib::askhardware::now() - alarmAt) >= 0) javinolib::askhardware::onAlarm();
}

namespace javinolib {
namespace askhardware {

uint8_t takenTimer() { return TCCR0A != 0 ? JAVINO_TAKEN_TIMER : 0; }

uint32_t ticksPerSecond() { return F_CPU / PRESCALER; }

uint16_t now() { return static_cast<uint16_t>(micros() / (PRESCALER / clockCyclesPerMicrosecond())); }

void setAlarm(uint16_t at) {
  alarmAt = at;
  OCR0B = static_cast<uint8_t>(at);
  TIMSK0 |= _BV(OCIE0B);
}

void clearAlarm() { TIMSK0 &= static_cast<uint8_t>(~_BV(OCIE0B)); }

void beginTimer() {
  clearAlarm();
  TCCR0A &= static_cast<uint8_t>(~(_BV(WGM01) | _BV(WGM00)));
}

}  // namespace askhardware
}  // namespace javinolib

#else

// A timer of 16 bits, which runs freely at an eighth of the CPU's clock (0.5 µs at 16 MHz).

#define JAVINO_PASTE(before, number, after) before##number##after
#define JAVINO_NUMBERED(before, number, after) JAVINO_PASTE(before, number, after)
#define JAVINO_TIMER(before, after) JAVINO_NUMBERED(before, JAVINO_RADIO_TIMER, after)

#define JAVINO_TIMERS_ISR(name) ISR(JAVINO_TIMER(TIMER, name), ISR_ALIASOF(JAVINO_TIMER(TIMER, _COMPB_vect)))

ISR(JAVINO_TIMER(TIMER, _COMPB_vect)) { javinolib::askhardware::onAlarm(); }
JAVINO_TIMERS_ISR(_OVF_vect);
JAVINO_TIMERS_ISR(_CAPT_vect);
#ifdef TIMER1_COMPC_vect
JAVINO_TIMERS_ISR(_COMPC_vect);
#endif
// On a Mega the library Servo defines this one of all timers, and takes timer 5, for 13 servos 1, for 25 3, for 37 4.
#if defined(OCR5BL) && JAVINO_RADIO_TIMER != 5
#define JAVINO_OTHERS_INTERRUPTS (JAVINO_TIMER(TIMSK, ) & static_cast<uint8_t>(~_BV(JAVINO_TIMER(OCIE, B))))
#else
#define JAVINO_OTHERS_INTERRUPTS 0
JAVINO_TIMERS_ISR(_COMPA_vect);
#endif

namespace javinolib {
namespace askhardware {

static const uint8_t PRESCALER = 8;

JAVINO_OUT_OF_LINE uint8_t takenTimer() {
  return (JAVINO_TIMER(TCCR, A) | JAVINO_OTHERS_INTERRUPTS) != 0 ? JAVINO_TAKEN_TIMER : 0;
}

uint32_t ticksPerSecond() { return F_CPU / PRESCALER; }

uint16_t now() { return JAVINO_TIMER(TCNT, ); }

// Out of line: 30 bytes of an Uno's flash less, 9 of some 8000 cycles a bit more.
JAVINO_OUT_OF_LINE void setAlarm(uint16_t at) {
  JAVINO_TIMER(OCR, B) = at;
  JAVINO_TIMER(TIFR, ) |= _BV(JAVINO_TIMER(OCF, B));  // one instruction, for this flag alone
  JAVINO_TIMER(TIMSK, ) = JAVINO_OTHERS_INTERRUPTS | _BV(JAVINO_TIMER(OCIE, B));
}

JAVINO_OUT_OF_LINE void clearAlarm() {
  JAVINO_TIMER(TIMSK, ) = JAVINO_OTHERS_INTERRUPTS;
  JAVINO_TIMER(TIFR, ) |= _BV(JAVINO_TIMER(OCF, B));
}

void beginTimer() {
  JAVINO_TIMER(TCCR, A) &= static_cast<uint8_t>(~(_BV(JAVINO_TIMER(WGM, 1)) | _BV(JAVINO_TIMER(WGM, 0))));
  JAVINO_TIMER(TCCR, B) = _BV(JAVINO_TIMER(CS, 1));
}

}  // namespace askhardware
}  // namespace javinolib

#endif
