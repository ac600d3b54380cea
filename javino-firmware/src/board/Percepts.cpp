#include "Percepts.h"

#include <math.h>
#include <string.h>

namespace javinolib {

namespace {

const char PERCEPT = 'P';
const uint8_t MAX_DIGITS = 20;  // of an unsigned long, be it of 64 bits
const uint8_t DECIMALS = 2;
const int MOST_MILLIONS = 21;  // so that hundredths fit a long

// In place of a number: as an AgentSpeak variable, which no agent believes.
const char UNWRITABLE[][6] JAVINO_FLASH = {"(Ovf)", "(Inf)", "(NaN)"};

void addEscaped(Record &record, char next) {
  const bool newline = next == '\n';
  if (newline || next == '"' || next == '\\') record.add('\\');
  record.add(static_cast<uint8_t>(newline ? 'n' : next));
}

// `(number)`, the last digits of which may be decimals. AVR takes 600 cycles to divide 32 bits, and 200 for 16.
JAVINO_NOINLINE void addNumber(Record &record, bool negative, unsigned long number, uint8_t decimals) {
  uint8_t text[1 + 1 + MAX_DIGITS + 1 + 1];
  uint8_t *const end = text + sizeof text;
  uint8_t *first = end;
  *--first = ')';
  uint8_t digits = 0;
  do {
    if (decimals != 0 && digits == decimals) *--first = '.';
    uint8_t digit;
    if (number > UINT16_MAX) {
      digit = static_cast<uint8_t>(number % 10);
      number /= 10;
    } else {
      digit = static_cast<uint8_t>(static_cast<uint16_t>(number) % 10);
      number = static_cast<uint16_t>(number) / 10;
    }
    *--first = static_cast<uint8_t>('0' + digit);
    digits++;
  } while (number != 0 || digits <= decimals);
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

static uint32_t bitsOf(float number) {
  uint32_t bits;
  memcpy(&bits, &number, sizeof bits);
  return bits & 0x7FFFFFFF;
}

// By its bits, which grow with the number, as comparisons of AVR's library take 170 bytes more.
long Percepts::hundredths(double number) {
  const uint32_t infinity = 0x7F800000;
  const uint32_t bits = bitsOf(static_cast<float>(number));
#ifdef __AVR__
  const bool isWritable = bits < bitsOf(MOST_MILLIONS * 1e6f);
#else
  const bool isWritable = number > MOST_MILLIONS * -1e6 && number < MOST_MILLIONS * 1e6;
#endif
  if (isWritable) return lround(number * 100);
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
    addNumber(record, number < 0, magnitude, DECIMALS);
  } else {
    record.add(reinterpret_cast<const FlashText *>(UNWRITABLE[number - BEYOND]));
  }
  close(record);
}

void Percepts::write(const FlashText *name, bool negative, unsigned long magnitude) {
  Record record(reply_, PERCEPT);
  record.add(name);
  addNumber(record, negative, magnitude, 0);
  close(record);
}

void Percepts::close(Record &record) {
  if (!record.close()) leftOut_++;
}

}  // namespace javinolib
