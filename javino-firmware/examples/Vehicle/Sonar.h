#pragma once

#include <Arduino.h>

/// An HC-SR04 that measures in the background, about sixteen times a second. There can be one of it.
class Sonar {
 public:
  static const uint16_t MIN_CM = 2;
  static const uint16_t MAX_CM = 400;

  /// @param triggerPin any digital pin
  /// @param echoPin a pin with an external interrupt (Mega: 2, 3, 18-21)
  Sonar(uint8_t triggerPin, uint8_t echoPin) : triggerPin_(triggerPin), echoPin_(echoPin) {}

  void begin();

  /// Takes in the last echo and asks for the next when its time has come; to be called in each loop().
  void update();

  /// @return whether the last measurement found something at 2…400 cm.
  bool inRange() const { return centimetres_ >= MIN_CM && centimetres_ <= MAX_CM; }

  /// @return that distance.
  uint16_t centimetres() const { return centimetres_; }

 private:
  const uint8_t triggerPin_;
  const uint8_t echoPin_;
  uint16_t centimetres_ = 0;
  uint32_t lastTriggerMs_ = 0;
};
