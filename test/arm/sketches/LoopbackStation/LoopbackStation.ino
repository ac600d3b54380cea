// A board with a radio and keys on a chip other than an AVR: by the radio of the example OwnRadio, whose other end greets.

#include <EEPROM.h>
#include <JavinoBDI.h>

#include "11_OwnRadio/LoopbackRadio.h"

LoopbackRadio radios[2];
JavinoRadioBoard board(Serial, "loopback 1.0", radios[0]);
JavinoBroadcaster other(radios[1]);
unsigned long greetedAt;

void setup() {
  radios[0].join(radios[1]);
  other.begin("BETA");
  board.begin(115200);
}

void loop() {
  board.run();
  other.run();
  if (millis() - greetedAt < 100) return;
  greetedAt = millis();
  other.send("tell;hello");
}
