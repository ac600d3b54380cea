#pragma once

#include <stdint.h>

namespace javinolib {

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
#endif

}  // namespace eeprom
}  // namespace javinolib
