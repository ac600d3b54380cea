// A plant's soil, and an alarm whose action takes half a second.

#include <Javino.h>

Javino javino;
int moisture = 0;
bool alarming = false;

void alarm() {
  for (int hertz = 1000; hertz < 2000; hertz += 20) {
    tone(11, hertz);
    delay(10);
  }
  noTone(11);
  alarming = true;
}

void quiet() { alarming = false; }

void perceive() {
  javino.addPercept("moisture(" + String(moisture) + ")");
  if (alarming) javino.addPercept("alarming(true)");
}

void setup() {
  pinMode(11, OUTPUT);
  javino.act["alarm"] = alarm;
  javino.act["quiet"] = quiet;
  javino.perceive(perceive);
  javino.start(9600);
}

void loop() {
  moisture = map(analogRead(A0), 1023, 400, 0, 100);
  moisture = constrain(moisture, 0, 100);
  javino.run();
}

void serialEvent() { javino.readSerial(); }
