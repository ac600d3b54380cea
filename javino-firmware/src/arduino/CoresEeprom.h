#pragma once

#include "../storage/Eeprom.h"
#include "../storage/EepromLayout.h"
#include "../support/Core.h"

#ifndef __AVR__

// The builder has it where the sketch includes it before. (Of two lines that ask for a file which is not there, gcc 12 takes the
// second for done.)
#ifdef __has_include
#if __has_include(<EEPROM.h>)
#include <EEPROM.h>
#define JAVINO_CORE_HAS_EEPROM
#endif
#endif

namespace javinolib {

#ifdef JAVINO_CORE_HAS_EEPROM

/// The core's `EEPROM`. On some chips it is a copy in RAM of a page of flash, which begin() makes and commit() stores; others
/// have no commit(). It is compiled with the sketch, as only the sketch's builder knows whether there is one.
template <typename Chip>
class CoresEeprom : public Eeprom {
 public:
  explicit CoresEeprom(Chip &chip) : chip_(chip), isOpen_(false) {}

  uint8_t read(uint16_t at) override {
    open(chip_, 0);
    return chip_.read(at);
  }

  void write(uint16_t at, uint8_t value) override {
    open(chip_, 0);
    chip_.write(at, value);
  }

  void commit() override { store(chip_, 0); }

 private:
  template <typename Copy>
  auto open(Copy &chip, int) -> decltype(chip.commit(), void()) {
    if (!isOpen_) chip.begin(LAYOUT_END);
    isOpen_ = true;
  }

  template <typename Direct>
  void open(Direct &, long) {}

  template <typename Copy>
  auto store(Copy &chip, int) -> decltype(chip.commit(), void()) {
    chip.commit();
  }

  template <typename Direct>
  void store(Direct &, long) {}

  Chip &chip_;
  bool isOpen_;
};

template <typename Port>
Eeprom &coresEeprom() {
  static CoresEeprom<decltype(EEPROM)> cores(EEPROM);
  return cores;
}

#else

template <typename Port>
Eeprom &coresEeprom() {
  static_assert(sizeof(Port) == 0,
                "keys need a memory: #include <EEPROM.h> before this library or, if the core has none, give the board "
                "a JavinoEeprom (example OwnEeprom)");
  static Eeprom *none;
  return *none;
}

#endif

}  // namespace javinolib

#endif
