// The same beside a radio.
//
// Actions: wait(Millis), in the action; keep(Number), in the EEPROM; strip(Micros), interrupts off in each call of loop(), as
// a strip of lamps has them.

#include <EEPROM.h>
#include <JavinoBDI.h>

JavinoAskRadio radio;
JavinoRadioBoard board(Serial, "neighbour station 1.0", radio);
long stripMicros;
int waited = 0;

bool wait(const JavinoArguments &arguments) {
  long millis;
  if (!arguments.integer(0, millis)) return false;
  delay(millis);
  waited++;
  return true;
}

bool keep(const JavinoArguments &arguments) {
  long number;
  if (!arguments.integer(0, number)) return false;
  EEPROM.put(0, number);
  return true;
}

bool strip(const JavinoArguments &arguments) { return arguments.integer(0, stripMicros); }

void perceive(JavinoPercepts &percepts) { percepts.add(F("waited"), waited); }

void setup() {
  board.onPercepts(perceive);
  board.action(F("wait"), wait);
  board.action(F("keep"), keep);
  board.action(F("strip"), strip);
  board.begin(115200);
}

void loop() {
  board.run();
  if (stripMicros == 0) return;
  noInterrupts();
  for (long i = 0; i < stripMicros; i += 100) delayMicroseconds(100);
  interrupts();
}
