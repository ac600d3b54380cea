// A lamp by the published library's interface, with functions.

#include <Javino.h>

Javino javino;

void lampOn() { digitalWrite(13, HIGH); }

void lampOff() { digitalWrite(13, LOW); }

void perceive() {
  if (digitalRead(13)) {
    javino.addPercept("lamp(on)");
  } else {
    javino.addPercept("lamp(off)");
  }
}

void setup() {
  pinMode(13, OUTPUT);
  javino.act["lampOn"] = lampOn;
  javino.act["lampOff"] = lampOff;
  javino.perceive(perceive);
  javino.start(9600);
}

void loop() { javino.run(); }

void serialEvent() { javino.readSerial(); }
