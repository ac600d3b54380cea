// Tells an agent that a button is pressed: an event, which it does not miss even if it is busy meanwhile.
//
// Wiring: push button between pin 2 and GND. USB to the computer that runs the agent.
//
// No actions.
// Percepts: pressed   while the button is down

#include <JavinoBDI.h>

const uint8_t BUTTON_PIN = 2;

JavinoBoard board(Serial, "button 1.0");

void perceive(JavinoPercepts &percepts) { percepts.event(F("pressed"), digitalRead(BUTTON_PIN) == LOW); }

void setup() {
  pinMode(BUTTON_PIN, INPUT_PULLUP);
  board.onPercepts(perceive);
  board.begin(115200);
}

void loop() { board.run(); }
