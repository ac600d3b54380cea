// A Station whose sketch has left the stack next to nothing: it runs over the memory of nonces.

#include <JavinoBDI.h>

const uint8_t LEFT_BYTES = 60;

extern uint8_t __heap_start;  // behind all static memory

JavinoAskRadio radio;
JavinoRadioBoard board(Serial, "full RAM 1.0", radio);

void setup() { board.begin(115200); }

void loop() {
  __attribute__((unused)) volatile uint8_t taken[SP - reinterpret_cast<uint16_t>(&__heap_start) - LEFT_BYTES];
  taken[0] = 1;  // so that it is there
  board.run();
  taken[0] = 2;
}
