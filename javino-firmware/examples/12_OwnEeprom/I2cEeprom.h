#pragma once

#include <JavinoBDI.h>
#include <Wire.h>

/// An example of a driver for another memory than the core's `EEPROM`: a 24LC32 or larger, or an FRAM with the same commands.
class I2cEeprom : public JavinoEeprom {
 public:
  explicit I2cEeprom(uint8_t address) : address_(address) {}

  uint8_t read(uint16_t at) override {
    select(at);
    Wire.endTransmission();
    Wire.requestFrom(address_, static_cast<uint8_t>(1));
    return static_cast<uint8_t>(Wire.read());
  }

  // The chip stores the byte within 5 ms, and does not answer meanwhile.
  void write(uint16_t at, uint8_t value) override {
    select(at);
    Wire.write(value);
    Wire.endTransmission();
    for (const unsigned long begin = millis(); millis() - begin <= STORE_MILLIS;) {
      Wire.beginTransmission(address_);
      if (Wire.endTransmission() == 0) break;
    }
  }

 private:
  static const unsigned long STORE_MILLIS = 5;

  void select(uint16_t at) {
    Wire.beginTransmission(address_);
    Wire.write(static_cast<uint8_t>(at >> 8));
    Wire.write(static_cast<uint8_t>(at & 0xFF));
  }

  const uint8_t address_;
};
