#include "LineCode.h"

#include "../support/Flash.h"

namespace javinolib {
namespace linecode {

namespace {

const uint8_t SYMBOLS[16] JAVINO_FLASH = {0x0D, 0x0E, 0x13, 0x15, 0x16, 0x19, 0x1A, 0x1C,
                                          0x23, 0x25, 0x26, 0x29, 0x2A, 0x2C, 0x32, 0x34};

// From the first of these symbols to the last: with a search, reading a packet takes half as long again.
const uint8_t NO = NO_NIBBLE;
const uint8_t FIRST_SYMBOL = 0x0D;
const uint8_t NIBBLES[] JAVINO_FLASH = {0,  1,  NO, NO, NO, NO, 2,  NO, 3,  4,  NO, NO, 5,  6,  NO, 7,  NO, NO, NO, NO,
                                        NO, NO, 8,  NO, 9,  10, NO, NO, 11, 12, NO, 13, NO, NO, NO, NO, NO, 14, NO, 15};

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
  const uint8_t index = static_cast<uint8_t>(symbol - FIRST_SYMBOL);
  return index < sizeof NIBBLES ? flashByte(NIBBLES + index) : NO_NIBBLE;
}

uint8_t onesOf(uint8_t byte) {
  uint8_t ones = 0;
  for (; byte != 0; byte = static_cast<uint8_t>(byte & (byte - 1))) ones++;
  return ones;
}

uint8_t trailerSymbolOf(uint8_t nibble) {
  const uint8_t symbol = symbolOf(nibble);
  return symbol == REPLACED_SYMBOL ? TRAILER_SYMBOL : symbol;
}

uint8_t trailerNibbleOf(uint8_t symbol) {
  if (symbol == TRAILER_SYMBOL) return REPLACED_NIBBLE;
  return symbol == REPLACED_SYMBOL ? NO_NIBBLE : nibbleOf(symbol);
}

namespace {

uint8_t nibbleOfEither(uint8_t symbol, bool inTrailer) {
  return inTrailer ? trailerNibbleOf(symbol) : nibbleOf(symbol);
}

}  // namespace

uint16_t nearestTo(uint8_t one, uint8_t two, bool inTrailer, uint8_t &distance) {
  distance = onesOf(one ^ two);
  if (distance <=
      2) {  // what is in the table is nearer than all else, if the other is not: twice as fast as a search of all
    uint8_t first = nibbleOfEither(one, inTrailer);
    uint8_t second = one == two ? first : nibbleOfEither(two, inTrailer);
    if (first == NO_NIBBLE) first = second;
    if (second == NO_NIBBLE) second = first;
    if (first == second && first != NO_NIBBLE) return static_cast<uint16_t>(1 << first);
  }
  uint16_t nearest = 0;
  distance = UINT8_MAX;
  for (uint8_t nibble = 16; nibble-- != 0;) {
    const uint8_t symbol = inTrailer ? trailerSymbolOf(nibble) : symbolOf(nibble);
    const uint8_t wrong = static_cast<uint8_t>(onesOf(symbol ^ one) + onesOf(symbol ^ two));
    nearest = static_cast<uint16_t>(nearest << 1);
    if (wrong > distance) continue;
    if (wrong < distance) nearest = 0;
    distance = wrong;
    nearest |= 1;
  }
  return nearest;
}

namespace {

bool isWord(uint16_t bits, uint8_t word, uint8_t mostWrong) {
  const uint16_t wrong = static_cast<uint16_t>(
      bits ^ (trailerSymbolOf(static_cast<uint8_t>(word >> 4)) | trailerSymbolOf(word) << BITS_PER_SYMBOL));
  return onesOfWord(wrong) <= mostWrong;
}

}  // namespace

Trailer trailerOf(uint16_t bits) {
  if (isWord(bits, TRAILER_PARITY, 2)) return Trailer::PARITY;
  return isWord(bits, TRAILER_MARK, 1) ? Trailer::MARK : Trailer::NONE;
}

uint8_t parityLength(uint8_t count) { return count <= 48 ? 12 : 16; }

uint8_t preambleSymbol(uint8_t index) {
  if (index < PREAMBLE_SYMBOLS - 2) return TRAINING_SYMBOL;
  return index == PREAMBLE_SYMBOLS - 2 ? FIRST_START_SYMBOL : SECOND_START_SYMBOL;
}

}  // namespace linecode
}  // namespace javinolib
