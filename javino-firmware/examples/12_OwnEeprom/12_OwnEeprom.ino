// Gives an agent a radio on a chip whose core has no EEPROM.h, as a Zero or a Due: RF id, keys and nonces are in an I2C EEPROM.
//
// Wiring: SDA and SCL of a 24LC32 or larger, its address pins to ground; an HC-12 at TX1 and RX1. USB to the computer that runs
// the agent.
//
// Where an EEPROM may be read by others, so may the keys. RAM will not do, not even to try: after each reset the board would use
// the nonces of its keys once more.
//
// No actions, no percepts. The lamp on the board stays dark unless the radio or the EEPROM fails.

#include <JavinoBDI.h>

#include "I2cEeprom.h"

I2cEeprom memory(0x50);
JavinoSerialRadio radio(Serial1, JAVINO_HC_12);
JavinoRadioBoard board(Serial, "station 1.0", radio, memory);

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  Wire.begin();
  digitalWrite(LED_BUILTIN, !board.begin(115200));
}

void loop() { board.run(); }
