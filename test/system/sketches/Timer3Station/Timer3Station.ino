// The library's example Station with its radio on timer 3.

#define JAVINO_RADIO_TIMER 3
#include <JavinoBDI.h>

// Timer 1 is free, all its interrupts too.
EMPTY_INTERRUPT(TIMER1_COMPA_vect)
EMPTY_INTERRUPT(TIMER1_COMPB_vect)
EMPTY_INTERRUPT(TIMER1_OVF_vect)

JavinoAskRadio radio;
JavinoRadioBoard board(Serial, "timer 3 station 1.0", radio);

void setup() { board.begin(115200); }

void loop() { board.run(); }
