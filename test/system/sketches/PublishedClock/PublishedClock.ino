// Percepts that the sketch sends by itself, each second, without being asked.

#include <Javino.h>

Javino javino;
unsigned long toldAt;

void setup() { javino.start(9600); }

void loop() {
  javino.run();
  if (millis() - toldAt < 1000) return;
  toldAt = millis();
  javino.addPercept("uptime(" + String(toldAt / 1000) + ")");
  javino.addPercept("device(clock)");
  javino.sendPercepts();
}

void serialEvent() { javino.readSerial(); }
