// An oven: a lever by pulses, a thermometer that is read in loop(), texts in percepts.

#include <Javino.h>

Javino javino;
int lever = 1500;
float temperature = 0;

void power() {
  digitalWrite(13, !digitalRead(13));
  lever = digitalRead(13) ? 600 : 1500;
}

void perceive() {
  if (temperature > 100) javino.addPercept("status(\"burnt\")");
  javino.addPercept("temperature(" + String(temperature) + ")");
  javino.addPercept(digitalRead(13) ? "power(\"on\")" : "power(\"off\")");
}

void setup() {
  pinMode(13, OUTPUT);
  pinMode(9, OUTPUT);
  javino.act["power"] = power;
  javino.perceive(perceive);
  javino.start(9600);
}

void loop() {
  javino.run();
  digitalWrite(9, HIGH);
  delayMicroseconds(lever);
  digitalWrite(9, LOW);
  temperature = 20.0 + analogRead(A0) / 1023.0 * 100.0;
}

void serialEvent() { javino.readSerial(); }
