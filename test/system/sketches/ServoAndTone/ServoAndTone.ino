// A radio beside a servo and a buzzer. The radio is on timer 0, with millis(); the servo takes timer 1 as Arduino's library
// Servo does on an Uno (the interrupt of compare unit A, and the timer set back at each pulse), tone() takes timer 2.
//
// Actions: turn(Micros), the length of the servo's pulse; beep(Hertz); quiet.

#define JAVINO_RADIO_TIMER 0
#include <JavinoBDI.h>

const uint8_t BUZZER_PIN = 8;
const uint8_t SERVO_PIN = 9;
const uint8_t TICKS_A_MICRO = 2;
const uint16_t PERIOD_MICROS = 20000;

volatile uint16_t pulseMicros = 1500;

JavinoAskRadio radio;
JavinoRadioBoard board(Serial, "servo and tone 1.0", radio);

ISR(TIMER1_COMPA_vect) {
  if (digitalRead(SERVO_PIN)) {
    digitalWrite(SERVO_PIN, LOW);
    OCR1A = PERIOD_MICROS * TICKS_A_MICRO;
  } else {
    TCNT1 = 0;
    OCR1A = pulseMicros * TICKS_A_MICRO;
    digitalWrite(SERVO_PIN, HIGH);
  }
}

bool turn(const JavinoArguments &arguments) {
  long micros;
  if (!arguments.integer(0, micros) || micros < 544 || micros > 2400) return false;
  noInterrupts();
  pulseMicros = micros;
  interrupts();
  return true;
}

bool beep(const JavinoArguments &arguments) {
  long hertz;
  if (!arguments.integer(0, hertz) || hertz < 31 || hertz > 20000) return false;
  tone(BUZZER_PIN, hertz);
  return true;
}

bool quiet(const JavinoArguments &) {
  noTone(BUZZER_PIN);
  return true;
}

void setup() {
  pinMode(SERVO_PIN, OUTPUT);
  TCCR1A = 0;
  TCCR1B = _BV(CS11);
  OCR1A = PERIOD_MICROS * TICKS_A_MICRO;
  TIMSK1 = _BV(OCIE1A);
  board.action(F("turn"), turn);
  board.action(F("beep"), beep);
  board.action(F("quiet"), quiet);
  board.begin(115200);
}

void loop() { board.run(); }
