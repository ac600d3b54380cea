#include "Percepts.h"

#include <math.h>
#include <string.h>

namespace javinolib {

namespace {

const char PERCEPT = 'P';
const uint8_t MAX_DIGITS = 20;  // of an unsigned long, be it of 64 bits
const uint8_t DECIMALS = 2;
const uint8_t NO_DECIMALS = 0xFF;

// In place of a number: as an AgentSpeak variable, which no agent believes.
const char UNWRITABLE[][6] JAVINO_FLASH = {"(Ovf)", "(Inf)", "(NaN)"};

void addEscaped(Record &record, char next) {
  const bool newline = next == '\n';
  if (newline || next == '"' || next == '\\') record.add('\\');
  record.add(static_cast<uint8_t>(newline ? 'n' : next));
}

// The digits of a number of 16 bits, but for the last.
const uint16_t UNITS[] JAVINO_FLASH = {10000, 1000, 100, 10};
const uint8_t UNIT_COUNT = sizeof UNITS / sizeof *UNITS;

// `(number)`. AVR takes 600 cycles to divide 32 bits, and 200 for 16: so there are only as many divisions as the number has
// digits beyond 16 bits, and these are then split by subtraction.
void addNumber(Record &record, bool negative, unsigned long number, uint8_t hundredths = NO_DECIMALS) {
  uint8_t text[1 + 1 + MAX_DIGITS + 1 + DECIMALS + 1];
  uint8_t *const end = text + sizeof text;
  uint8_t *first = end;
  *--first = ')';
  if (hundredths != NO_DECIMALS) {
    *--first = static_cast<uint8_t>('0' + hundredths % 10);
    *--first = static_cast<uint8_t>('0' + hundredths / 10);
    *--first = '.';
  }
  for (; number > UINT16_MAX; number /= 10) *--first = static_cast<uint8_t>('0' + number % 10);
  uint8_t *at = first -= UNIT_COUNT + 1;
  uint16_t rest = static_cast<uint16_t>(number);
  for (const uint16_t *next = UNITS; next != UNITS + UNIT_COUNT; next++) {
    const uint16_t unit = flashWord(next);
    uint8_t digit = '0';
    for (; rest >= unit; rest = static_cast<uint16_t>(rest - unit)) digit++;
    *at++ = digit;
  }
  *at = static_cast<uint8_t>('0' + rest);
  while (*first == '0' && first != at) first++;
  if (negative) *--first = '-';
  *--first = '(';
  record.add(first, static_cast<Length>(end - first));
}

}  // namespace

char Percepts::Text::operator[](uint16_t index) const {
  return inFlash ? flashChar(reinterpret_cast<const FlashText *>(at), index) : at[index];
}

void Percepts::add(const FlashText *name, long number) {
  const unsigned long magnitude = static_cast<unsigned long>(number);
  write(name, number < 0, number < 0 ? 0 - magnitude : magnitude);
}

void Percepts::add(const FlashText *name, unsigned long number) { write(name, false, number); }

void Percepts::write(const Text &literal) {
  Record record(reply_, PERCEPT);
  for (uint16_t i = 0; literal[i] != 0; i++) record.add(static_cast<uint8_t>(literal[i]));
  close(record);
}

void Percepts::write(const FlashText *name, const Text &text) {
  Record record(reply_, PERCEPT);
  record.add(name);
  record.add('(');
  record.add('"');
  for (uint16_t i = 0; text[i] != 0; i++) addEscaped(record, text[i]);
  record.add('"');
  record.add(')');
  close(record);
}

// By its bits, which grow with the number, as comparisons of AVR's library take 170 bytes more.
long Percepts::hundredths(double number) {
#ifdef __AVR__
  const uint32_t twentyOneMillions = 0x4BA037A0;
#else
  if (number > -21e6 && number < 21e6) return lround(number * 100);
#endif
  const uint32_t infinity = 0x7F800000;
  const float single = static_cast<float>(number);
  uint32_t bits;
  memcpy(&bits, &single, sizeof bits);
  bits &= 0x7FFFFFFF;
#ifdef __AVR__
  if (bits < twentyOneMillions) return lround(number * 100);
#endif
  return bits < infinity ? BEYOND : bits == infinity ? INFINITE : NONE;
}

void Percepts::addSettled(const FlashText *name, double number, double deadBand, unsigned long leastMillis) {
  long told = hundredths(number);
  if (told < BEYOND) {
    told = deadBands_.settle(name, told, static_cast<unsigned long>(hundredths(deadBand)), leastMillis);
  }
  addHundredths(name, told);
}

void Percepts::addHundredths(const FlashText *name, long number) {
  const unsigned long magnitude =
      number < 0 ? 0 - static_cast<unsigned long>(number) : static_cast<unsigned long>(number);
  Record record(reply_, PERCEPT);
  record.add(name);
  if (number < BEYOND) {
    addNumber(record, number < 0, magnitude / 100, static_cast<uint8_t>(magnitude % 100));
  } else {
    record.add(reinterpret_cast<const FlashText *>(UNWRITABLE[number - BEYOND]));
  }
  close(record);
}

void Percepts::write(const FlashText *name, bool negative, unsigned long magnitude) {
  Record record(reply_, PERCEPT);
  record.add(name);
  addNumber(record, negative, magnitude);
  close(record);
}

void Percepts::close(Record &record) {
  if (!record.close()) leftOut_++;
}

}  // namespace javinolib
