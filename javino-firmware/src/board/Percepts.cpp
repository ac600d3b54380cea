#include "Percepts.h"

namespace javino {

namespace {

const char PERCEPT = 'P';
const uint8_t MAX_DIGITS = 20;  // of an unsigned long, be it of 64 bits

void addText(Record &record, const FlashText *text) {
  char next;
  for (uint16_t i = 0; (next = flashChar(text, i)) != 0; i++) record.add(static_cast<uint8_t>(next));
}

void addEscaped(Record &record, char next) {
  if (next == '"' || next == '\\') record.add('\\');
  if (next == '\n') {
    record.add('\\');
    next = 'n';
  }
  record.add(static_cast<uint8_t>(next));
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

void openText(Record &record, const FlashText *name) {
  addText(record, name);
  record.add('(');
  record.add('"');
}

void closeText(Record &record) {
  record.add('"');
  record.add(')');
}

}  // namespace

void Percepts::add(const FlashText *name) { literal(name); }

void Percepts::add(const FlashText *name, long number) {
  const unsigned long magnitude = static_cast<unsigned long>(number);
  addNumber(name, number < 0, number < 0 ? 0 - magnitude : magnitude);
}

void Percepts::add(const FlashText *name, unsigned long number) { addNumber(name, false, number); }

void Percepts::add(const FlashText *name, const char *text) {
  Record record(reply_, PERCEPT);
  openText(record, name);
  for (; *text != 0; text++) addEscaped(record, *text);
  closeText(record);
  close(record);
}

void Percepts::add(const FlashText *name, const FlashText *text) {
  Record record(reply_, PERCEPT);
  openText(record, name);
  char next;
  for (uint16_t i = 0; (next = flashChar(text, i)) != 0; i++) addEscaped(record, next);
  closeText(record);
  close(record);
}

void Percepts::literal(const char *literal) {
  Record record(reply_, PERCEPT);
  for (; *literal != 0; literal++) record.add(static_cast<uint8_t>(*literal));
  close(record);
}

void Percepts::literal(const FlashText *literal) {
  Record record(reply_, PERCEPT);
  addText(record, literal);
  close(record);
}

void Percepts::addNumber(const FlashText *name, bool negative, unsigned long magnitude) {
  Record record(reply_, PERCEPT);
  addText(record, name);
  record.add('(');
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
