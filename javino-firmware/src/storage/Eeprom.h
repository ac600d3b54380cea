#pragma once

#include <stdint.h>

namespace javinolib {

/// A driver of a memory for RF id, keys and nonces on a chip whose core has no `EEPROM`, or one that is too small: an EEPROM or
/// FRAM at a bus. It has 4096 bytes, 1024 with JAVINO_SMALL, of any value at first.
class Eeprom {
 public:
  /// @param at 0…4095
  virtual uint8_t read(uint16_t at) = 0;

  /// Writes a byte and waits for it. What was written before another byte is there before it, also if power fails between.
  virtual void write(uint16_t at, uint8_t value) = 0;

  /// Called after writes, once a turn of loop(): stores them, where write() only takes note of them.
  virtual void commit() {}

 protected:
  ~Eeprom() = default;
};

/// Bytes that survive a loss of power. The seam for the EEPROM; bound when linking, to ArduinoSeams.cpp on a board and
/// to a simulated one in the host tests, torn writes and all. A chip has one EEPROM, so there is no object to pass.
namespace eeprom {

uint8_t read(uint16_t at);

/// Writes a byte and waits for it: some 3.4 ms on an ATmega. It is written where it reads so already too, since a cell in
/// which power failed may read one time so and one time otherwise. Whether the cell kept it, read() tells.
void write(uint16_t at, uint8_t value);

/// Has all that was written outlive a loss of power, on chips where write() alone does not.
#ifdef __AVR__
inline void commit() {}
#else
void commit();

/// Has all that follows done to this memory.
void use(Eeprom &memory);
#endif

}  // namespace eeprom
}  // namespace javinolib
