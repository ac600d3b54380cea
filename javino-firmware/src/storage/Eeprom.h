#pragma once

#include <stdint.h>

namespace javino {

/// Bytes that survive a loss of power. The seam for the EEPROM; host tests put a simulated one here, torn writes and
/// all.
class Eeprom {
 public:
  virtual uint8_t read(uint16_t at) const = 0;

  /// Writes a byte where it differs from what is there, and waits for it: some 3.4 ms on an ATmega.
  /// Whether the cell kept it, read() tells.
  virtual void update(uint16_t at, uint8_t value) = 0;

 protected:
  ~Eeprom() {}
};

}  // namespace javino
