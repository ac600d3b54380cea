#ifdef __AVR__
#include <EEPROM.h>
#endif

#include "../storage/Eeprom.h"
#include "../storage/Retained.h"
#include "../support/Clock.h"
#include "../support/Core.h"

// The seams Eeprom, Retained and Clock on the Arduino core.

namespace javinolib {

#ifdef __AVR__

// The EEPROM's writes wait with interrupts on: serial bytes and the radio go on meanwhile.
uint8_t eeprom::read(uint16_t at) { return EEPROM.read(at); }

void eeprom::write(uint16_t at, uint8_t value) { EEPROM.write(at, value); }

#else

static Eeprom *memory;
static bool isChanged;

void eeprom::use(Eeprom &used) { memory = &used; }

uint8_t eeprom::read(uint16_t at) { return memory->read(at); }

void eeprom::write(uint16_t at, uint8_t value) {
  memory->write(at, value);
  isChanged = true;
}

void eeprom::commit() {
  if (isChanged) memory->commit();
  isChanged = false;
}

#endif

// The start-up code clears .bss and fills .data, but leaves .noinit, which the linker places right behind them. On a Mega
// the boot loader runs before each start-up: its own variables lie at the bottom of the RAM, its stack at the top; what
// is in the middle, above some hundred bytes of .data and .bss, it does not touch.
#ifdef __AVR__
static TakenNonces nonces __attribute__((section(".noinit")));

TakenNonces &retained::takenNonces() { return nonces; }

static retained::Airtime keptAirtime __attribute__((section(".noinit")));
#else
static retained::Airtime keptAirtime;

TakenNonces &retained::takenNonces() {
  // Elsewhere it is cleared too. No epoch follows this one.
  static struct Cleared : TakenNonces {
    Cleared() : TakenNonces() { epoch = UINT32_MAX - 1; }
  } nonces;
  return nonces;
}
#endif

retained::Airtime &retained::airtime() { return keptAirtime; }

// There is room for an interrupt, and for the functions that write there. Where the stack of another chip is, is not known.
static bool hasOverrun;

bool retained::isClear() {
#ifdef __AVR__
  if (SP < reinterpret_cast<uint16_t>(&nonces + 1) + 32) hasOverrun = true;
#endif
  return !hasOverrun;
}

uint32_t clock::millis() { return ::millis(); }

}  // namespace javinolib
