// A board with a lamp and a light sensor.
//
// Wiring: light dependent resistor from A0 to 5 V, 10 kΩ from A0 to ground; the lamp is the one on the board (pin 13).
//
// Percepts: light(L)  0 (dark) … 1023 (bright)
//           lamp(on) or lamp(off)
// Actions:  lampOn, lampOff

#include <JavinoBDI.h>

JavinoBoard board(Serial, "robot 1.0");

void perceive(JavinoPercepts &percepts) {
  percepts.add(F("light"), analogRead(A0), 4);  // a change of less than 4 is none: the sensor trembles
  percepts.literal(digitalRead(LED_BUILTIN) ? F("lamp(on)") : F("lamp(off)"));
}

bool lampOn(const JavinoArguments &) {
  digitalWrite(LED_BUILTIN, HIGH);
  return true;
}

bool lampOff(const JavinoArguments &) {
  digitalWrite(LED_BUILTIN, LOW);
  return true;
}

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  board.onPercepts(perceive);
  board.action(F("lampOn"), lampOn);
  board.action(F("lampOff"), lampOff);
  board.begin(115200);
}

void loop() { board.run(); }
