#pragma once

#include <stdint.h>

/// Arduino's EEPROM library; calls go to the EepromMock that is alive.
class EEPROMClass {
 public:
  uint8_t read(int at);
  void write(int at, uint8_t value);
};

extern EEPROMClass EEPROM;
