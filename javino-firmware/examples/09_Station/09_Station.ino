// Gives an agent a radio, for a station without sensors and motors.
//
// Wiring: 433 MHz receiver's data to pin 11, transmitter's data to pin 12. USB to the computer that runs the agent.
//
// No actions, no percepts. The lamp on the board (pin 13) stays dark unless the radio or the EEPROM fails.

#include <JavinoBDI.h>

#ifdef SERIAL_MODULE  // JAVINO_HC_12, JAVINO_E32 or JAVINO_E22: TX1 at 18, RX1 at 19
JavinoSerialRadio radio(Serial1, SERIAL_MODULE);
#else
JavinoAskRadio radio;
#endif
JavinoRadioBoard board(Serial, "station 1.0", radio);

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  digitalWrite(LED_BUILTIN, !board.begin(115200));
}

void loop() { board.run(); }
