#include "Sonar.h"

namespace {

// The data sheet's: echoes of one measurement have died away after 60 ms; sound needs 58 µs for 1 cm and back.
const uint32_t PERIOD_MS = 60;
const uint32_t MICROS_PER_CM = 58;
const uint8_t TRIGGER_MICROS = 10;

const uint32_t NO_ECHO = 0;

uint8_t echoInput;
volatile uint32_t echoBegan;
volatile uint32_t echoMicros = NO_ECHO;

void onEcho() {
  const uint32_t now = micros();
  if (digitalRead(echoInput)) {
    echoBegan = now;
  } else {
    echoMicros = now - echoBegan;
  }
}

uint32_t takeEcho() {
  noInterrupts();
  const uint32_t taken = echoMicros;
  echoMicros = NO_ECHO;
  interrupts();
  return taken;
}

}  // namespace

void Sonar::begin() {
  echoInput = echoPin_;
  pinMode(triggerPin_, OUTPUT);
  pinMode(echoPin_, INPUT);
  attachInterrupt(digitalPinToInterrupt(echoPin_), onEcho, CHANGE);
}

void Sonar::update() {
  const uint32_t now = millis();
  if (now - lastTriggerMs_ < PERIOD_MS) return;
  lastTriggerMs_ = now;
  const uint32_t echo = takeEcho() / MICROS_PER_CM;
  centimetres_ = echo <= MAX_CM ? echo : 0;
  digitalWrite(triggerPin_, HIGH);
  delayMicroseconds(TRIGGER_MICROS);
  digitalWrite(triggerPin_, LOW);
}
