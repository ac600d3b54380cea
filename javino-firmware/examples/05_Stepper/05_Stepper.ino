// Turns a stepper motor beside an agent: loop() makes a step as soon as it is due, so it calls serve(), which does not sleep.
//
// Wiring: a motor driver as A4988 or DRV8825: STEP to pin 3, DIR to pin 4, GND to GND; the motor and its supply as the
// driver's page says. USB to the computer that runs the agent.
//
// Actions:  turn(Steps)       negative ones turn back
// Percepts: position(Steps)   told twice a second while it turns
//           turning           until it is there

#include <JavinoBDI.h>

const uint8_t STEP_PIN = 3;
const uint8_t DIRECTION_PIN = 4;

const uint16_t STEP_MICROS = 667;  // 1500 steps a second
const uint16_t TELL_MILLIS = 500;

JavinoBoard board(Serial, "stepper 1.0");

long position = 0;
long target = 0;
uint16_t steppedAt;

bool turn(const JavinoArguments &arguments) {
  long steps;
  if (!arguments.integer(0, steps)) return false;
  target = position + steps;
  return true;
}

void perceive(JavinoPercepts &percepts) {
  percepts.add(F("position"), position, 0, TELL_MILLIS);
  if (position != target) percepts.add(F("turning"));
}

// A late step does not make the next one come sooner, as the motor would miss that.
void step() {
  const uint16_t now = micros();
  if (position == target || static_cast<uint16_t>(now - steppedAt) < STEP_MICROS) return;
  steppedAt = now;
  const bool onward = target > position;
  digitalWrite(DIRECTION_PIN, onward);
  digitalWrite(STEP_PIN, HIGH);
  digitalWrite(STEP_PIN, LOW);
  position += onward ? 1 : -1;
}

void setup() {
  pinMode(STEP_PIN, OUTPUT);
  pinMode(DIRECTION_PIN, OUTPUT);
  board.onPercepts(perceive);
  board.action(F("turn"), turn);
  board.begin(115200);
}

void loop() {
  step();
  board.serve();
}
