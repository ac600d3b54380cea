// Lets an agent switch a lamp, and perceive whether it is lit. This is the smallest useful sketch.
//
// Wiring: none; the lamp is the one on the board (pin 13). USB to the computer that runs the agent.
//
// Actions:  ledOn, ledOff
// Percepts: led(on) or led(off)

#include <JavinoBDI.h>

JavinoBoard board(Serial, "blink 1.0");

bool ledOn(const JavinoArguments &) {
  digitalWrite(LED_BUILTIN, HIGH);
  return true;
}

bool ledOff(const JavinoArguments &) {
  digitalWrite(LED_BUILTIN, LOW);
  return true;
}

void perceive(JavinoPercepts &percepts) { percepts.literal(digitalRead(LED_BUILTIN) ? F("led(on)") : F("led(off)")); }

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  board.onPercepts(perceive);
  board.action(F("ledOn"), ledOn);
  board.action(F("ledOff"), ledOff);
  board.begin(115200);
}

void loop() { board.run(); }
