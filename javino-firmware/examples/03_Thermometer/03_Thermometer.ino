// Gives an agent the temperature.
//
// Wiring: analog temperature sensor TMP36: supply to 5 V (3.3 V on a board of 3.3 V), ground to GND, output to A0.
// USB to the computer that runs the agent.
//
// No actions.
// Percepts: celsius(T)   in °C, -40…125, such as celsius(24.71)

#include <JavinoBDI.h>

const uint8_t SENSOR_PIN = A0;

// The data sheet's: 500 mV at 0 °C, 10 mV more for each degree.
const float MILLIVOLTS_AT_ZERO = 500;
const float MILLIVOLTS_A_DEGREE = 10;

// The voltage that the converter reads as 1024: a Pro Mini with a clock of 8 MHz has 3.3 V.
#ifdef __AVR__
const float SUPPLY_MILLIVOLTS = F_CPU < 16000000 ? 3300 : 5000;
#else
const float SUPPLY_MILLIVOLTS = 3300;  // an UNO R4 has 5000
#endif

// One reading has steps of half a degree; this many take 2 ms, and their mean has finer ones.
const uint8_t READINGS = 16;

// A smaller change is none: the sensor trembles.
const float DEAD_BAND = 0.5;

const uint16_t SAMPLE_MILLIS = 1000;

JavinoBoard board(Serial, "thermometer 1.0");

float celsius() {
  unsigned int sum = 0;
  for (uint8_t i = 0; i < READINGS; i++) sum += analogRead(SENSOR_PIN);
  const float millivolts = sum * SUPPLY_MILLIVOLTS / (1024L * READINGS);
  return (millivolts - MILLIVOLTS_AT_ZERO) / MILLIVOLTS_A_DEGREE;
}

void perceive(JavinoPercepts &percepts) { percepts.add(F("celsius"), celsius(), DEAD_BAND); }

void setup() {
  board.onPercepts(perceive);
  board.sampleEvery(SAMPLE_MILLIS);
  board.begin(115200);
}

void loop() { board.run(); }
