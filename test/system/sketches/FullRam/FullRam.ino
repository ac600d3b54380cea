// A Station whose sketch has left the stack next to nothing: it runs over the memory of nonces.

#include <Javino.h>

javinolib::Javino board(Serial, "full RAM 1.0");

volatile char buffer[780];

void setup() {
  buffer[0] = 1;  // so that it is there
  board.begin(115200);
}

void loop() { board.run(); }
