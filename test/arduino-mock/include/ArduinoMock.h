#pragma once

#include <gmock/gmock.h>
#include <stdint.h>

/// Stands behind the free functions of the Arduino core while it lives; there is at most one at a time, and the
/// functions may be called only then.
class ArduinoMock {
 public:
  ArduinoMock();
  ~ArduinoMock();

  MOCK_METHOD(void, pinMode, (uint8_t pin, uint8_t mode));
  MOCK_METHOD(void, digitalWrite, (uint8_t pin, uint8_t value));
  MOCK_METHOD(int, digitalRead, (uint8_t pin));
  MOCK_METHOD(int, analogRead, (uint8_t pin));
  MOCK_METHOD(unsigned long, millis, ());
  MOCK_METHOD(unsigned long, micros, ());
};
