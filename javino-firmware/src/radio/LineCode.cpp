#include "LineCode.h"

#include "../support/Flash.h"

namespace javino {
namespace linecode {

namespace {

const uint8_t SYMBOLS[16] JAVINO_FLASH = {0x0D, 0x0E, 0x13, 0x15, 0x16, 0x19, 0x1A, 0x1C,
                                          0x23, 0x25, 0x26, 0x29, 0x2A, 0x2C, 0x32, 0x34};

// The one symbol in which the trailer's alphabet differs.
const uint8_t REPLACED_NIBBLE = 4;
const uint8_t REPLACED_SYMBOL = 0x16;
const uint8_t TRAILER_SYMBOL = 0x07;

const uint8_t TRAINING_SYMBOL = 0x2A;
const uint8_t FIRST_START_SYMBOL = 0x38;
const uint8_t SECOND_START_SYMBOL = 0x2C;

}  // namespace

uint8_t symbolOf(uint8_t nibble) { return flashByte(SYMBOLS + (nibble & 0x0F)); }

uint8_t nibbleOf(uint8_t symbol) {
  // The table ascends and its upper half begins at 0x20: eight comparisons instead of sixteen.
  uint8_t nibble = (symbol & 0x20) ? 8 : 0;
  do {
    if (flashByte(SYMBOLS + nibble) == symbol) return nibble;
    nibble++;
  } while (nibble % 8 != 0);
  return NO_NIBBLE;
}

uint8_t trailerSymbolOf(uint8_t nibble) {
  const uint8_t symbol = symbolOf(nibble);
  return symbol == REPLACED_SYMBOL ? TRAILER_SYMBOL : symbol;
}

uint8_t trailerNibbleOf(uint8_t symbol) {
  if (symbol == TRAILER_SYMBOL) return REPLACED_NIBBLE;
  return symbol == REPLACED_SYMBOL ? NO_NIBBLE : nibbleOf(symbol);
}

bool isOneBitOff(uint8_t symbol) {
  if (symbol == 0 || symbol == 0x3F) return false;
  symbol ^= symbol >> 4;
  symbol ^= symbol >> 2;
  symbol ^= symbol >> 1;
  return !(symbol & 1);
}

uint8_t preambleSymbol(uint8_t index) {
  if (index < PREAMBLE_SYMBOLS - 2) return TRAINING_SYMBOL;
  return index == PREAMBLE_SYMBOLS - 2 ? FIRST_START_SYMBOL : SECOND_START_SYMBOL;
}

}  // namespace linecode
}  // namespace javino
