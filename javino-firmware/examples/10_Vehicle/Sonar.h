#pragma once

#include <Arduino.h>

/// An HC-SR04 on a Mega that measures in the background, about sixteen times a second. There can be one of it.
class Sonar {
 public:
  static const uint16_t MIN_CM = 2;
  static const uint16_t MAX_CM = 400;

  /// The echo's pin is fixed, as its interrupt is.
  static const uint8_t ECHO_PIN = 2;

  /// @param triggerPin any digital pin
  explicit constexpr Sonar(uint8_t triggerPin) : triggerPin_(triggerPin) {}

  void begin();

  /// Takes in the last echo and asks for the next when its time has come; to be called in each loop().
  void update();

  /// @return whether the last measurement found something at 2…400 cm.
  bool inRange() const { return centimetres_ >= MIN_CM && centimetres_ <= MAX_CM; }

  /// @return that distance.
  uint16_t centimetres() const { return centimetres_; }

 private:
  const uint8_t triggerPin_;
  uint16_t centimetres_ = 0;
  uint32_t lastTriggerMs_ = 0;
};
