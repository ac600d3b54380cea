#include "EepromRecord.h"

#include "../support/Crc16.h"
#include "Eeprom.h"

namespace javinolib {

const uint8_t EepromRecord::CHECK_LENGTH;

namespace {

const uint8_t ERASED = 0xFF;
const uint8_t ALL_SEALS = 7;  // as bits
const uint8_t READINGS = 8;   // that show whether a seal's byte is weak

enum Seals : uint8_t { LOOK, MEND, WRITE };

// Writes the bytes of the seal, all or those that are wrong. Any two of the three tell the whole CRC.
// Returns which were right, as bits.
JAVINO_NOINLINE uint8_t handleSeals(uint16_t at, uint8_t length, const uint8_t *data, Seals how) {
  Crc16 crc;
  crc.add(data, length);
  uint8_t seal = static_cast<uint8_t>(crc.value() >> 8);
  uint8_t next = static_cast<uint8_t>(crc.value());
  uint8_t right = 0;
  at = static_cast<uint16_t>(at + length);
  for (uint8_t bit = 1; bit != ALL_SEALS + 1; bit = static_cast<uint8_t>(bit << 1), at++) {
    const uint8_t stored = seal == ERASED ? 0 : seal;
    if (how != WRITE && eeprom::read(at) == stored) {
      right |= bit;
    } else if (how != LOOK) {
      eeprom::write(at, stored);
    }
    const uint8_t both = static_cast<uint8_t>(seal ^ next);
    seal = next;
    next = both;
  }
  return right;
}

JAVINO_NOINLINE bool holds(uint16_t at, uint8_t length, const uint8_t *data) {
  for (uint8_t i = 0; i < length; i++) {
    if (eeprom::read(static_cast<uint16_t>(at + i)) != data[i]) return false;
  }
  return handleSeals(at, length, data, LOOK) == ALL_SEALS;
}

JAVINO_NOINLINE bool isErased(uint16_t at, uint8_t count) {
  for (; count != 0; count--) {
    if (eeprom::read(at++) != ERASED) return false;
  }
  return true;
}

// The last one first.
JAVINO_NOINLINE void eraseBytes(uint16_t at, uint8_t count) {
  while (count-- != 0) eeprom::write(static_cast<uint16_t>(at + count), ERASED);
}

}  // namespace

bool EepromRecord::begin(uint16_t at, uint8_t length, uint8_t *data, uint8_t secrets) {
  if (!read(at, length, data) && !read(at, length, data)) {
    erase(at, length, secrets);
    return false;
  }
  for (uint8_t i = 0; i < READINGS; i++) handleSeals(at, length, data, MEND);
  return true;
}

bool EepromRecord::read(uint16_t at, uint8_t length, uint8_t *data) {
  for (uint8_t i = 0; i < length; i++) data[i] = eeprom::read(static_cast<uint16_t>(at + i));
  const uint8_t right = handleSeals(at, length, data, LOOK);
  return (right & (right - 1)) != 0;  // two of them
}

bool EepromRecord::write(uint16_t at, uint8_t length, const uint8_t *data) {
  if (holds(at, length, data)) return true;
  erase(at, length, 0);
  for (uint8_t i = 0; i < length; i++) eeprom::write(static_cast<uint16_t>(at + i), data[i]);
  handleSeals(at, length, data, WRITE);
  if (holds(at, length, data)) return true;
  erase(at, length, 0);
  return false;
}

// The seal goes whole or not at all: what reads as erased may be weak.
bool EepromRecord::erase(uint16_t at, uint8_t length, uint8_t secrets) {
  const uint16_t seals = static_cast<uint16_t>(at + length);
  if (isErased(seals, CHECK_LENGTH) && isErased(at, secrets)) return true;
  eraseBytes(seals, CHECK_LENGTH);
  eraseBytes(at, secrets);
  return isErased(seals, CHECK_LENGTH);
}

}  // namespace javinolib
