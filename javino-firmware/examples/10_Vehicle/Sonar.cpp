#include "Sonar.h"

namespace {

// The data sheet's: echoes of one measurement have died away after 60 ms; sound needs 58 µs for 1 cm and back.
const uint32_t PERIOD_MS = 60;
const uint32_t MICROS_PER_CM = 58;
const uint8_t TRIGGER_MICROS = 10;

const uint32_t NO_ECHO = 0;

volatile bool echoing = false;
volatile uint32_t echoBegan;
volatile uint32_t echoMicros = NO_ECHO;

uint32_t takeEcho() {
  noInterrupts();
  const uint32_t taken = echoMicros;
  echoMicros = NO_ECHO;
  interrupts();
  return taken;
}

}  // namespace

// Pin 2 of a Mega is PE4, with interrupt INT4. Arduino's attachInterrupt() would serve any such pin, but brings the
// code of all eight interrupts along: 880 bytes of flash. A sketch that calls it for another pin cannot have both.
ISR(INT4_vect) {
  const uint32_t now = micros();
  if (PINE & _BV(PE4)) {
    echoing = true;
    echoBegan = now;
  } else if (echoing) {  // else it began before this sketch did: the board was reset in the middle of it
    echoing = false;
    echoMicros = now - echoBegan;
  }
}

void Sonar::begin() {
  pinMode(triggerPin_, OUTPUT);
  pinMode(ECHO_PIN, INPUT);
  EICRB = (EICRB & ~_BV(ISC41)) | _BV(ISC40);  // at each change of the pin
  EIMSK |= _BV(INT4);
}

void Sonar::update() {
  const uint32_t now = millis();
  if (now - lastTriggerMs_ < PERIOD_MS) return;
  lastTriggerMs_ = now;
  // To the nearest centimetre: another interrupt may hold up either edge for some microseconds.
  const uint32_t echo = (takeEcho() + MICROS_PER_CM / 2) / MICROS_PER_CM;
  centimetres_ = echo <= MAX_CM ? echo : 0;
  digitalWrite(triggerPin_, HIGH);
  delayMicroseconds(TRIGGER_MICROS);
  digitalWrite(triggerPin_, LOW);
}
