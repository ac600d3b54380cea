// Hangs when it is told to: in an action, or in its percepts.

#include <JavinoBDI.h>

JavinoBoard board(Serial, "hanging 1.0");

volatile bool hangs;

bool hang(const JavinoArguments &) {
  for (;;) {
  }
}

bool hangInPercepts(const JavinoArguments &) { return hangs = true; }

void percepts(JavinoPercepts &p) {
  while (hangs) {
  }
  p.add(F("works"));
}

void setup() {
  board.onPercepts(percepts);
  board.action(F("hang"), hang);
  board.action(F("hangInPercepts"), hangInPercepts);
  board.begin(115200);
}

void loop() { board.run(); }
