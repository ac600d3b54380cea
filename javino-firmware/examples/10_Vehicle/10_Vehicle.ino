// A vehicle: it drives, measures the distance ahead, has headlights, and can sound an alarm or a siren.
//
// Wiring:
//   HC-SR04 ultrasonic sensor    trigger to 22, echo to 2 (no other pin: see Sonar.cpp)
//   light dependent resistor     divider of LDR (to 5 V) and 10 kΩ (to ground) to A0
//   L298N motor driver           left motor: 5 forward, 6 backward; right motor: 7 forward, 8 backward
//   active buzzer                9
//   headlights                   30
//   siren lamps                  31 and 32
//   433 MHz receiver and transmitter  data to 11 and 12
//   lamp on the board            lit if the radio or the EEPROM fails
//
// Actions:  drive, stop, accidentAlert, alertOff, sirenOn, sirenOff, headlightsOn, headlightsOff
// Percepts: proximity(Cm)   distance to an obstacle ahead, 2…400 cm; absent while none is in that range
//           light(L)        0 (dark) … 1023 (bright)
//           moving          while the motors run

#include <JavinoBDI.h>

#include "Siren.h"
#include "Sonar.h"

const uint8_t LIGHT_PIN = A0;
const uint8_t LEFT_FORWARD_PIN = 5;
const uint8_t LEFT_BACKWARD_PIN = 6;
const uint8_t RIGHT_FORWARD_PIN = 7;
const uint8_t RIGHT_BACKWARD_PIN = 8;
const uint8_t BUZZER_PIN = 9;
const uint8_t HEADLIGHTS_PIN = 30;

// Both sensors tremble: smaller changes are none.
const uint8_t PROXIMITY_DEAD_BAND = 2;  // cm
const uint8_t LIGHT_DEAD_BAND = 4;

#ifdef SERIAL_MODULE  // JAVINO_HC_12, JAVINO_E32 or JAVINO_E22: TX1 at 18, RX1 at 19
JavinoSerialRadio radio(Serial1, SERIAL_MODULE);
#else
JavinoAskRadio radio;
#endif
JavinoRadioBoard board(Serial, "vehicle 1.0", radio);
Sonar sonar(22);
Siren siren(31, 32);

bool moving = false;
bool alerting = false;

void drive(bool forward) {
  moving = forward;
  digitalWrite(LEFT_BACKWARD_PIN, LOW);
  digitalWrite(RIGHT_BACKWARD_PIN, LOW);
  digitalWrite(LEFT_FORWARD_PIN, forward);
  digitalWrite(RIGHT_FORWARD_PIN, forward);
}

// The alert and the siren share the buzzer.
void updateBuzzer() { digitalWrite(BUZZER_PIN, alerting || siren.on()); }

bool startDriving(const JavinoArguments &) {
  drive(true);
  return true;
}

bool stopDriving(const JavinoArguments &) {
  drive(false);
  return true;
}

bool accidentAlert(const JavinoArguments &) {
  alerting = true;
  updateBuzzer();
  return true;
}

bool alertOff(const JavinoArguments &) {
  alerting = false;
  updateBuzzer();
  return true;
}

bool sirenOn(const JavinoArguments &) {
  siren.start();
  updateBuzzer();
  return true;
}

bool sirenOff(const JavinoArguments &) {
  siren.stop();
  updateBuzzer();
  return true;
}

bool headlightsOn(const JavinoArguments &) {
  digitalWrite(HEADLIGHTS_PIN, HIGH);
  return true;
}

bool headlightsOff(const JavinoArguments &) {
  digitalWrite(HEADLIGHTS_PIN, LOW);
  return true;
}

void perceive(JavinoPercepts &percepts) {
  if (sonar.inRange()) percepts.add(F("proximity"), sonar.centimetres(), PROXIMITY_DEAD_BAND);
  percepts.add(F("light"), analogRead(LIGHT_PIN), LIGHT_DEAD_BAND);
  if (moving) percepts.add(F("moving"));
}

void setup() {
  const uint8_t outputs[] = {LEFT_FORWARD_PIN, LEFT_BACKWARD_PIN, RIGHT_FORWARD_PIN, RIGHT_BACKWARD_PIN,
                             BUZZER_PIN,       HEADLIGHTS_PIN,    LED_BUILTIN};
  for (uint8_t i = 0; i < sizeof outputs; i++) pinMode(outputs[i], OUTPUT);
  sonar.begin();
  siren.begin();

  board.onPercepts(perceive);
  board.sampleEvery(5);
  const bool named = board.action(F("drive"), startDriving) && board.action(F("stop"), stopDriving) &&
                     board.action(F("accidentAlert"), accidentAlert) && board.action(F("alertOff"), alertOff) &&
                     board.action(F("sirenOn"), sirenOn) && board.action(F("sirenOff"), sirenOff) &&
                     board.action(F("headlightsOn"), headlightsOn) && board.action(F("headlightsOff"), headlightsOff);
  const bool started = board.begin(115200);
  digitalWrite(LED_BUILTIN, !(named && started));
}

void loop() {
  board.run();
  sonar.update();
  siren.update();
}
