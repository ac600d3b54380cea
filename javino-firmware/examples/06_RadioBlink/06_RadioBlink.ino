// The example Blink with a radio: other agents can ask for the lamp too.
//
// Wiring: 433 MHz receiver's data to pin 11, transmitter's data to pin 12. The lamp is the one on the board (pin 13).
//
// Actions:  ledOn, ledOff
// Percepts: led(on) or led(off)

#include <JavinoBDI.h>

JavinoAskRadio radio;
JavinoRadioBoard board(Serial, "radio blink 1.0", radio);

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
