#pragma once

#include <EEPROM.h>

#include "../storage/Eeprom.h"

namespace javino {

/// The EEPROM of the chip, through Arduino's EEPROM library. Its writes wait with interrupts on: serial bytes and the
/// radio go on meanwhile.
class ArduinoEeprom : public Eeprom {
 public:
  uint8_t read(uint16_t at) const override { return EEPROM.read(at); }
  void update(uint16_t at, uint8_t value) override { EEPROM.update(at, value); }
};

}  // namespace javino
