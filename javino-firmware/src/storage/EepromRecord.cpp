#include "EepromRecord.h"

#include "../support/Crc16.h"
#include "Eeprom.h"

namespace javinolib {

const uint8_t EepromRecord::CHECK_LENGTH;

namespace {

const uint8_t ERASED = 0xFF;
const uint8_t READINGS = 8;  // that show whether a seal's byte is weak

// Writes the seal behind the data: any two of its three bytes tell the whole CRC.
JAVINO_NOINLINE void seal(uint8_t *data, uint8_t length) {
  Crc16 crc;
  crc.add(data, length);
  data += length;
  data[0] = static_cast<uint8_t>(crc.value() >> 8);
  data[1] = static_cast<uint8_t>(crc.value());
  data[2] = data[0] ^ data[1];
  for (uint8_t i = 0; i != EepromRecord::CHECK_LENGTH; i++) {
    if (data[i] == ERASED) data[i] = 0;
  }
}

enum Repair : uint8_t { NONE, MEND, WRITE };

// Returns how many bytes differed, and writes those, or all.
JAVINO_NOINLINE uint8_t compare(uint16_t at, const uint8_t *bytes, uint8_t count, Repair repair) {
  uint8_t wrong = 0;
  for (; count != 0; count--, at++, bytes++) {
    const bool differs = eeprom::read(at) != *bytes;
    if (differs) wrong++;
    if (repair == WRITE || (differs && repair == MEND)) eeprom::write(at, *bytes);
  }
  return wrong;
}

JAVINO_NOINLINE bool isErased(uint16_t at, uint8_t count) {
  for (; count != 0; count--) {
    if (eeprom::read(at++) != ERASED) return false;
  }
  return true;
}

}  // namespace

bool EepromRecord::begin(uint16_t at, uint8_t length, uint8_t *data, uint8_t secrets) {
  if (!read(at, length, data) && !read(at, length, data)) {
    erase(at, length, secrets);
    return false;
  }
  for (uint8_t i = 0; i < READINGS; i++) {
    compare(static_cast<uint16_t>(at + length), data + length, CHECK_LENGTH, MEND);
  }
  return true;
}

bool EepromRecord::read(uint16_t at, uint8_t length, uint8_t *data) {
  for (uint8_t i = 0; i < length; i++) data[i] = eeprom::read(at++);
  seal(data, length);
  return compare(at, data + length, CHECK_LENGTH, NONE) <= 1;
}

bool EepromRecord::write(uint16_t at, uint8_t length, uint8_t *data) {
  const uint8_t all = static_cast<uint8_t>(length + CHECK_LENGTH);
  seal(data, length);
  if (compare(at, data, all, NONE) == 0) return true;
  erase(at, length, 0);
  compare(at, data, all, WRITE);
  if (compare(at, data, all, NONE) == 0) return true;
  erase(at, length, 0);
  return false;
}

// The seal goes whole or not at all: what reads as erased may be weak. The last byte goes first.
bool EepromRecord::erase(uint16_t at, uint8_t length, uint8_t secrets) {
  const uint16_t sealAt = static_cast<uint16_t>(at + length);
  const uint8_t count = static_cast<uint8_t>(secrets + CHECK_LENGTH);
  at = static_cast<uint16_t>(sealAt - secrets);
  if (!isErased(at, count)) {
    for (uint8_t left = count; left-- != 0;) eeprom::write(static_cast<uint16_t>(at + left), ERASED);
  }
  return isErased(sealAt, CHECK_LENGTH);
}

}  // namespace javinolib
