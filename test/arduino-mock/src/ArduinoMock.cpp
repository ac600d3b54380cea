#include "ArduinoMock.h"

#include "Arduino.h"
#include "Current.h"

ArduinoMock::ArduinoMock() { Current<ArduinoMock>::enter(this); }
ArduinoMock::~ArduinoMock() { Current<ArduinoMock>::leave(); }

static ArduinoMock &arduino() { return Current<ArduinoMock>::get("ArduinoMock"); }

void pinMode(uint8_t pin, uint8_t mode) { arduino().pinMode(pin, mode); }
void digitalWrite(uint8_t pin, uint8_t value) { arduino().digitalWrite(pin, value); }
int digitalRead(uint8_t pin) { return arduino().digitalRead(pin); }
int analogRead(uint8_t pin) { return arduino().analogRead(pin); }
unsigned long millis() { return arduino().millis(); }
unsigned long micros() { return arduino().micros(); }
