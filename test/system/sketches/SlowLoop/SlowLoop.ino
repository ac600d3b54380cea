// A sketch that waits in loop(), as examples of slow sensors do.

#include <JavinoBDI.h>

JavinoBoard board(Serial, "slow 1.0");

void percepts(JavinoPercepts &percepts) { percepts.add(F("celsius"), 21); }

void setup() {
  board.onPercepts(percepts);
  board.begin(115200);
}

void loop() {
  board.run();
  delay(2000);
}
