#pragma once

#include <stdint.h>
#include <string.h>

/// As on chips that keep a page of flash in RAM: what was not committed is lost at a reset.
class EEPROMClass {
 public:
  void begin(size_t size);
  uint8_t read(int at) { return copy_[at]; }
  void write(int at, uint8_t value) { copy_[at] = value; }
  bool commit();

  template <typename Value>
  void get(int at, Value &value) {
    memcpy(&value, copy_ + at, sizeof value);
  }
  template <typename Value>
  void put(int at, const Value &value) {
    memcpy(copy_ + at, &value, sizeof value);
  }

 private:
  uint8_t copy_[4096];
};

extern EEPROMClass EEPROM;
