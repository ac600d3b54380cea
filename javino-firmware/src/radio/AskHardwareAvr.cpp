#if defined(__AVR__)

#include <Arduino.h>
#include <avr/interrupt.h>

#include "AskHardware.h"
#include "AskRadio.h"

// Timer 1 runs freely at an eighth of the CPU's clock (0.5 µs at 16 MHz); its compare unit A is the alarm.

namespace {

const uint8_t PRESCALER = 8;

javino::AskRadio *modem;

volatile uint8_t *txRegister;
uint8_t txBit;
volatile uint8_t *rxRegister;
uint8_t rxBit;
volatile uint8_t *rxEdgeMask;  // PCMSK0, 1 or 2; its bits are those of the port, on Mega and Uno alike
uint8_t rxEdgeFlag;            // in PCICR and PCIFR

}  // namespace

ISR(PCINT0_vect) { modem->onEdge(TCNT1, *rxRegister & rxBit); }

#if defined(PCINT1_vect)
ISR(PCINT1_vect, ISR_ALIASOF(PCINT0_vect));
#endif

#if defined(PCINT2_vect)
ISR(PCINT2_vect, ISR_ALIASOF(PCINT0_vect));
#endif

ISR(TIMER1_COMPA_vect) { modem->onAlarm(); }

namespace javino {
namespace askhardware {

uint32_t ticksPerSecond() { return F_CPU / PRESCALER; }

bool begin(uint8_t rxPin, uint8_t txPin, AskRadio &radio) {
  if (rxPin >= NUM_DIGITAL_PINS || txPin >= NUM_DIGITAL_PINS || rxPin == txPin) return false;
  rxEdgeMask = digitalPinToPCMSK(rxPin);
  if (!rxEdgeMask) return false;

  InterruptLock lock;
  modem = &radio;
  digitalWrite(txPin, LOW);
  pinMode(txPin, OUTPUT);
  pinMode(rxPin, INPUT);
  txRegister = portOutputRegister(digitalPinToPort(txPin));
  txBit = digitalPinToBitMask(txPin);
  rxRegister = portInputRegister(digitalPinToPort(rxPin));
  rxBit = digitalPinToBitMask(rxPin);
  rxEdgeFlag = static_cast<uint8_t>(_BV(rxEdgeMask - &PCMSK0));
  PCICR |= rxEdgeFlag;

  TIMSK1 = 0;
  TCCR1A = 0;
  TCCR1B = _BV(CS11);
  return true;
}

uint16_t now() { return TCNT1; }

void setAlarm(uint16_t at) {
  OCR1A = at;
  TIFR1 = _BV(OCF1A);
  TIMSK1 = _BV(OCIE1A);
}

void clearAlarm() {
  TIMSK1 = 0;
  TIFR1 = _BV(OCF1A);
}

void watchEdges(bool on) {
  if (on) {
    PCIFR = rxEdgeFlag;
    *rxEdgeMask |= rxBit;
  } else {
    *rxEdgeMask &= static_cast<uint8_t>(~rxBit);
    PCIFR = rxEdgeFlag;
  }
}

void transmit(bool on) {
  if (on) {
    *txRegister |= txBit;
  } else {
    *txRegister &= static_cast<uint8_t>(~txBit);
  }
}

InterruptLock::InterruptLock() : before_(SREG) { cli(); }

InterruptLock::~InterruptLock() {
  __asm__ __volatile__("" ::: "memory");  // all that was written under the lock is written before it opens
  SREG = before_;
}

}  // namespace askhardware
}  // namespace javino

#endif
