#pragma once

#include <Arduino.h>

/// Two lamps that light in turn, twice a second each, while the siren is on.
class Siren {
 public:
  // constexpr: the object is ready when the program starts, and no code makes it.
  constexpr Siren(uint8_t leftPin, uint8_t rightPin) : leftPin_(leftPin), rightPin_(rightPin) {}

  void begin() {
    pinMode(leftPin_, OUTPUT);
    pinMode(rightPin_, OUTPUT);
  }

  bool on() const { return on_; }

  void start() {
    if (on_) return;
    on_ = true;
    lastChangeMs_ = millis();
    show(true, false);
  }

  void stop() {
    on_ = false;
    show(false, false);
  }

  /// To be called in each loop().
  void update() {
    if (!on_ || millis() - lastChangeMs_ < HALF_PERIOD_MS) return;
    lastChangeMs_ += HALF_PERIOD_MS;
    show(digitalRead(rightPin_), digitalRead(leftPin_));
  }

 private:
  static const uint32_t HALF_PERIOD_MS = 250;

  void show(bool left, bool right) {
    digitalWrite(leftPin_, left);
    digitalWrite(rightPin_, right);
  }

  const uint8_t leftPin_;
  const uint8_t rightPin_;
  bool on_ = false;
  uint32_t lastChangeMs_ = 0;
};
