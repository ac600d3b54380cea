// Hangs when it is told to: in an action, or in its percepts.

#include <Javino.h>

javinolib::Javino board(Serial, "hanging 1.0");

volatile bool hangs;

bool hang(const javinolib::Arguments &) {
  for (;;) {
  }
}

bool hangInPercepts(const javinolib::Arguments &) { return hangs = true; }

void percepts(javinolib::Percepts &p) {
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
