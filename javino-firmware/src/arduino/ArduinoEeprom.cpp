#include <EEPROM.h>

#include "../storage/Eeprom.h"

namespace javino {
namespace eeprom {

// The EEPROM of the chip. Its writes wait with interrupts on: serial bytes and the radio go on meanwhile.

uint8_t read(uint16_t at) { return EEPROM.read(at); }

void write(uint16_t at, uint8_t value) { EEPROM.write(at, value); }

}  // namespace eeprom
}  // namespace javino
