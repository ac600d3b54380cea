// Changes pin 5 every 10 ms, and sleeps in between. With the pin watched, the emulator's trace is a clock for programs
// that live beside the boards.

#include <avr/sleep.h>

const uint8_t kPin = 5;
const uint32_t kMillis = 10;

uint32_t next = kMillis;

void setup() {
  pinMode(kPin, OUTPUT);
  set_sleep_mode(SLEEP_MODE_IDLE);
}

void loop() {
  if (static_cast<int32_t>(millis() - next) >= 0) {
    next += kMillis;
    digitalWrite(kPin, !digitalRead(kPin));
  }
  sleep_mode();
}
