// A station whose radio sends for no more than 10 % of an hour.

#include <JavinoBDI.h>

JavinoAskRadio radio;
JavinoAirtimeLimit limited(radio, 10);
JavinoRadioBoard board(Serial, "limited station 1.0", limited);

void setup() { board.begin(115200); }

void loop() { board.run(); }
