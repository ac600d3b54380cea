// Lets an agent turn a servo: an action with an argument and a number, as .act(turn(90), Turned).
//
// Wiring: servo's signal (yellow or white) to pin 9, + (red) to 5 V, - (brown or black) to GND; a servo that is larger than
// an SG90 needs a supply of its own, whose - is at GND too. USB to the computer that runs the agent.
//
// Actions:  turn(Degrees)    0…180; all else fails with reason(beyond(180)). Returns by how much it has turned
// Percepts: angle(Degrees)   where it was told to turn last
//
// Beside a radio, Servo and the radio need different timers: see "Timer and pins of the radio" in the library's README.

#include <JavinoBDI.h>
#include <Servo.h>

const uint8_t SERVO_PIN = 9;
const uint8_t MOST_DEGREES = 180;

JavinoBoard board(Serial, "servo 1.0");
Servo servo;
uint8_t angle = 90;

bool turn(const JavinoArguments &arguments, JavinoResult &result) {
  long degrees;
  if (!arguments.integer(0, degrees) || degrees < 0 || degrees > MOST_DEGREES) {
    Serial.print(F("beyond(180)"));
    return false;
  }
  result.number(degrees - angle);
  angle = degrees;
  servo.write(angle);
  return true;
}

void perceive(JavinoPercepts &percepts) { percepts.add(F("angle"), angle); }

void setup() {
  servo.attach(SERVO_PIN);
  servo.write(angle);
  board.onPercepts(perceive);
  board.action(F("turn"), turn);
  board.begin(115200);
}

void loop() { board.run(); }
