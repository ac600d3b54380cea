// A robot that follows a line, as people build it: for its size on an Uno.
//
// Wiring: line sensors to A0 to A2, the battery by two equal resistors to A3, a bumper from pin 8 to ground; motor driver:
// speeds to pins 5 and 6, directions to pins 4 and 7; receiver to pin 11, transmitter to pin 12.
//
// Actions:  forward, left, right, halt, speed(0…255)
// Percepts: line_left, line_middle, line_right (0…1023), battery(Volts), speed(N), bumped

#include <JavinoBDI.h>

const uint8_t LEFT_SPEED = 5, RIGHT_SPEED = 6, LEFT_BACK = 4, RIGHT_BACK = 7, BUMPER = 8;

JavinoAskRadio radio;
JavinoRadioBoard board(Serial, "line follower 1.0", radio);

int speed = 150;

void drive(int left, int right) {
  digitalWrite(LEFT_BACK, left < 0);
  analogWrite(LEFT_SPEED, abs(left));
  digitalWrite(RIGHT_BACK, right < 0);
  analogWrite(RIGHT_SPEED, abs(right));
}

bool forward(const JavinoArguments &) {
  drive(speed, speed);
  return true;
}

bool left(const JavinoArguments &) {
  drive(-speed, speed);
  return true;
}

bool right(const JavinoArguments &) {
  drive(speed, -speed);
  return true;
}

bool halt(const JavinoArguments &) {
  drive(0, 0);
  return true;
}

bool setSpeed(const JavinoArguments &arguments) {
  long wanted;
  if (!arguments.integer(0, wanted) || wanted < 0 || wanted > 255) return false;
  speed = wanted;
  return true;
}

void perceive(JavinoPercepts &percepts) {
  percepts.add(F("line_left"), analogRead(A0), 20);
  percepts.add(F("line_middle"), analogRead(A1), 20);
  percepts.add(F("line_right"), analogRead(A2), 20);
  percepts.add(F("battery"), analogRead(A3) * 2 * 5.0 / 1023, 0.1);
  percepts.add(F("speed"), speed);
  if (digitalRead(BUMPER) == LOW) percepts.add(F("bumped"));
}

void setup() {
  pinMode(LEFT_SPEED, OUTPUT);
  pinMode(RIGHT_SPEED, OUTPUT);
  pinMode(LEFT_BACK, OUTPUT);
  pinMode(RIGHT_BACK, OUTPUT);
  pinMode(BUMPER, INPUT_PULLUP);
  board.onPercepts(perceive);
  board.action(F("forward"), forward);
  board.action(F("left"), left);
  board.action(F("right"), right);
  board.action(F("halt"), halt);
  board.action(F("speed"), setSpeed);
  board.begin(115200);
}

void loop() { board.run(); }
