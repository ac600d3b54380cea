#include <Arduino.h>

// Not all cores have one; a sketch for another chip that has a radio includes it, for builders to find it here.
#ifdef __AVR__
#include <EEPROM.h>
#elif __has_include(<EEPROM.h>)
#include <EEPROM.h>
#define JAVINO_EEPROM_MAY_BE_A_COPY
#endif

#include "../storage/Eeprom.h"
#include "../storage/EepromLayout.h"
#include "../storage/Retained.h"
#include "../support/Clock.h"

// The seams Eeprom, Retained and Clock on the Arduino core.

#ifdef __AVR__
#define JAVINO_RETAINED __attribute__((section(".noinit")))
#else
#define JAVINO_RETAINED
#endif

namespace javinolib {

#ifdef __AVR__

// The EEPROM's writes wait with interrupts on: serial bytes and the radio go on meanwhile.
uint8_t eeprom::read(uint16_t at) { return EEPROM.read(at); }

void eeprom::write(uint16_t at, uint8_t value) { EEPROM.write(at, value); }

#elif defined(JAVINO_EEPROM_MAY_BE_A_COPY)

namespace {

bool isOpen;
bool isChanged;

// On some chips EEPROM is a copy in RAM of a page of flash, which begin() makes and commit() stores; others have no commit().
template <typename Chip>
auto open(Chip &chip, int) -> decltype(chip.commit(), void()) {
  if (!isOpen) chip.begin(LAYOUT_END);
  isOpen = true;
}

template <typename Chip>
void open(Chip &, long) {}

template <typename Chip>
auto store(Chip &chip, int) -> decltype(chip.commit(), void()) {
  chip.commit();
}

template <typename Chip>
void store(Chip &, long) {}

}  // namespace

uint8_t eeprom::read(uint16_t at) {
  open(EEPROM, 0);
  return EEPROM.read(at);
}

void eeprom::write(uint16_t at, uint8_t value) {
  open(EEPROM, 0);
  EEPROM.write(at, value);
  isChanged = true;
}

void eeprom::commit() {
  if (isChanged) store(EEPROM, 0);
  isChanged = false;
}

#endif

// The start-up code clears .bss and fills .data, but leaves .noinit, which the linker places right behind them. On a Mega
// the boot loader runs before each start-up: its own variables lie at the bottom of the RAM, its stack at the top; what
// is in the middle, above some hundred bytes of .data and .bss, it does not touch.
static TakenNonces nonces JAVINO_RETAINED;

TakenNonces &retained::takenNonces() { return nonces; }

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
