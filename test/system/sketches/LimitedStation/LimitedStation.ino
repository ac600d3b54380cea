// A station whose radio sends for no more than a share of each hour: 1 %, or as the compiler is told.
//
// Wiring: 433 MHz receiver's data to pin 11, transmitter's data to pin 12.

#include <JavinoBDI.h>

#ifndef AIRTIME_PERCENT
#define AIRTIME_PERCENT 1
#endif

JavinoAskRadio radio;
JavinoAirtimeLimit limited(radio, AIRTIME_PERCENT);
JavinoRadioBoard board(Serial, "limited 1.0", limited);

void setup() { board.begin(115200); }

void loop() { board.run(); }
