#include "Percepts.h"

namespace javino {

namespace {

const char PERCEPT = 'P';
const uint8_t MAX_DIGITS = 20;  // of an unsigned long, be it of 64 bits

void addEscaped(Record &record, char next) {
  const bool newline = next == '\n';
  if (newline || next == '"' || next == '\\') record.add('\\');
  record.add(static_cast<uint8_t>(newline ? 'n' : next));
}

void addDigits(Record &record, unsigned long number) {
  uint8_t digits[MAX_DIGITS];
  uint8_t first = MAX_DIGITS;
  do {
    digits[--first] = static_cast<uint8_t>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  record.add(digits + first, static_cast<uint16_t>(MAX_DIGITS - first));
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

void Percepts::open(Record &record, const FlashText *name) {
  for (uint16_t i = 0; flashChar(name, i) != 0; i++) record.add(static_cast<uint8_t>(flashChar(name, i)));
  record.add('(');
}

void Percepts::write(const Text &literal) {
  Record record(reply_, PERCEPT);
  for (uint16_t i = 0; literal[i] != 0; i++) record.add(static_cast<uint8_t>(literal[i]));
  close(record);
}

void Percepts::write(const FlashText *name, const Text &text) {
  Record record(reply_, PERCEPT);
  open(record, name);
  record.add('"');
  for (uint16_t i = 0; text[i] != 0; i++) addEscaped(record, text[i]);
  record.add('"');
  record.add(')');
  close(record);
}

void Percepts::write(const FlashText *name, bool negative, unsigned long magnitude) {
  Record record(reply_, PERCEPT);
  open(record, name);
  if (negative) record.add('-');
  addDigits(record, magnitude);
  record.add(')');
  close(record);
}

void Percepts::close(Record &record) {
  if (record.close()) return;
  leftOut_ = true;
  counters_.count(Counter::PERCEPTS_LEFT_OUT);
}

}  // namespace javino
