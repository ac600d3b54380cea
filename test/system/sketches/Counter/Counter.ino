// A board that can tell whether any of its actions was performed twice: note(K) must come with rising K, and returns -K-1.
// It perceives how many came, how many did not rise, and the last.

#include <JavinoBDI.h>

JavinoBoard board(Serial, "counter 1.0");

long performed;
long repeated;
long last;

bool note(const JavinoArguments &arguments, JavinoResult &result) {
  long number;
  if (!arguments.integer(0, number)) {
    Serial.println(F("no(number)"));
    return false;
  }
  ++performed;
  if (number <= last) ++repeated;
  last = number;
  result.number(~number);
  return true;
}

void percepts(JavinoPercepts &p) {
  p.add(F("performed"), performed);
  p.add(F("repeated"), repeated);
  p.add(F("last"), last);
}

void setup() {
  board.onPercepts(percepts);
  board.action(F("note"), note);
  board.begin(115200);
}

void loop() { board.run(); }
