// An arm with a gripper.
//
// Wiring: the gripper's valve or relay at pin 8: HIGH closes it.
//
// Percepts: gripper(closed) or gripper(open)
// Actions:  close, open

#include <JavinoBDI.h>

const uint8_t GRIPPER_PIN = 8;

JavinoBoard board(Serial, "arm 1.0");

void perceive(JavinoPercepts &percepts) {
  percepts.literal(digitalRead(GRIPPER_PIN) ? F("gripper(closed)") : F("gripper(open)"));
}

bool close(const JavinoArguments &) {
  digitalWrite(GRIPPER_PIN, HIGH);
  return true;
}

bool open(const JavinoArguments &) {
  digitalWrite(GRIPPER_PIN, LOW);
  return true;
}

void setup() {
  pinMode(GRIPPER_PIN, OUTPUT);
  board.onPercepts(perceive);
  board.action(F("close"), close);
  board.action(F("open"), open);
  board.begin(115200);
}

void loop() { board.run(); }
