#include "AskHardware.h"

#ifdef JAVINO_HAS_ASK_HARDWARE

#include <Arduino.h>
#include <avr/interrupt.h>

#include "AskRadio.h"

// The pins; the timer is in AskHardwareAvrTimer.h.

namespace {

javinolib::AskRadio *modem;

volatile uint8_t *txRegister;
uint8_t txBit;
volatile uint8_t *rxRegister;
uint8_t rxBit;
volatile uint8_t *rxEdgeMask;  // PCMSK0, 1 or 2; its bits are those of the port, on all boards alike
uint8_t rxEdgeFlag;            // in PCICR and PCIFR

}  // namespace

ISR(PCINT0_vect) { modem->onEdge(javinolib::askhardware::now(), *rxRegister & rxBit); }

#if defined(PCINT1_vect)
ISR(PCINT1_vect, ISR_ALIASOF(PCINT0_vect));
#endif

#if defined(PCINT2_vect)
ISR(PCINT2_vect, ISR_ALIASOF(PCINT0_vect));
#endif

namespace javinolib {
namespace askhardware {

void beginTimer();  // AskHardwareAvrTimer.h

void onAlarm() { modem->onAlarm(); }

bool begin(uint8_t rxPin, uint8_t txPin, AskRadio &radio) {
  InterruptLock lock;
  beginTimer();  // first, as the core's setting of it would pass for another part's
  if (rxPin >= NUM_DIGITAL_PINS || txPin >= NUM_DIGITAL_PINS || rxPin == txPin) return false;
  rxEdgeMask = digitalPinToPCMSK(rxPin);
  if (!rxEdgeMask) return false;

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

  return takenTimer() == 0;
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
}  // namespace javinolib

#endif
