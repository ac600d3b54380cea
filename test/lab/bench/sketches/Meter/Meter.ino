// Has 40 percepts that change at each reading, at 115200 baud, or with a high level on pin 40 at 1000000.

#include <JavinoBDI.h>

const uint8_t FAST_PIN = 40;
const uint8_t PERCEPTS = 40;

JavinoBoard board(Serial, "meter 1.0");

int reading = 0;

void perceive(JavinoPercepts &percepts) {
  reading = reading % 999 + 1;
  for (uint8_t i = 0; i < PERCEPTS; i++) percepts.add(F("m"), i * 1000L + reading);
}

void setup() {
  board.onPercepts(perceive);
  board.sampleEvery(1);
  board.begin(digitalRead(FAST_PIN) ? 1000000 : 115200);
}

void loop() { board.run(); }
