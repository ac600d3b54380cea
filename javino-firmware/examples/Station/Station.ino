// Gives an agent a radio, for a station without sensors and motors.
//
// Wiring: 433 MHz receiver's data to pin 11, transmitter's data to pin 12. USB to the computer that runs the agent.
//
// No actions, no percepts. The lamp on the board (pin 13) stays dark unless the radio or the EEPROM fails.

#include <Javino.h>

#ifdef SERIAL_MODULE  // HC_12, E32 or E22: TX1 at 18, RX1 at 19
javinolib::SerialRadio radio(Serial1, javinolib::SERIAL_MODULE);
#else
javinolib::AskRadio radio;
#endif
javinolib::JavinoWithRadio board(Serial, "station 1.0", radio);

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  digitalWrite(LED_BUILTIN, !board.begin(115200));
}

void loop() { board.run(); }
