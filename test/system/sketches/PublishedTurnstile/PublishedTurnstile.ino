// Counts nothing: it tells what has passed since the agent was told last, and forgets it then. A lamp shows that it was asked.

#include <Javino.h>

Javino javino;
bool entered, left;

void perceive() {
  digitalWrite(13, HIGH);
  if (entered) javino.addPercept("passed(in)");
  if (left) javino.addPercept("passed(out)");
  entered = left = false;
}

void setup() {
  pinMode(13, OUTPUT);
  pinMode(2, INPUT);
  pinMode(3, INPUT);
  javino.perceive(perceive);
  javino.start(9600);
}

void loop() {
  javino.run();
  if (digitalRead(2)) entered = true;
  if (digitalRead(3)) left = true;
}

void serialEvent() { javino.readSerial(); }
