#include "EepromRecord.h"

#include "../support/Inlining.h"
#include "Eeprom.h"

namespace javinolib {

const uint8_t EepromRecord::CHECK_LENGTH;

static const uint8_t ERASED = 0xFF;

static const uint8_t ALL_SEALS = 7;  // as bits
static const uint8_t READINGS = 8;   // that show whether a seal's byte is weak

// Any two of the three tell the whole CRC.
JAVINO_NOINLINE static uint8_t sealOf(const Crc16 &crc, uint8_t index) {
  const uint8_t high = static_cast<uint8_t>(crc.value() >> 8);
  const uint8_t low = static_cast<uint8_t>(crc.value());
  const uint8_t seal = index == 0 ? high : index == 1 ? low : static_cast<uint8_t>(high ^ low);
  return seal == ERASED ? 0 : seal;
}

bool EepromRecord::begin(uint8_t *data, uint8_t secrets) const {
  if (!read(data) && !read(data)) {
    erase(secrets);
    return false;
  }
  const Crc16 crc = crcOf(data);
  for (uint8_t i = 0; i < READINGS; i++) storeSeals(crc, rightSeals(crc));
  return true;
}

bool EepromRecord::read(uint8_t *data) const {
  for (uint8_t i = 0; i < length_; i++) data[i] = stored(i);
  const uint8_t right = rightSeals(crcOf(data));
  return (right & (right - 1)) != 0;  // two of them
}

bool EepromRecord::write(const uint8_t *data) const {
  if (holds(data)) return true;
  erase(0);
  for (uint8_t i = 0; i < length_; i++) store(i, data[i]);
  storeSeals(crcOf(data), 0);
  if (holds(data)) return true;
  erase(0);
  return false;
}

// The seal goes whole or not at all: what reads as erased may be weak.
bool EepromRecord::erase(uint8_t secrets) const {
  if (isBlank(secrets)) return true;
  for (uint8_t i = CHECK_LENGTH; i != 0; i--) store(static_cast<uint8_t>(length_ + i - 1), ERASED);
  for (uint8_t i = 0; i < secrets; i++) store(i, ERASED);
  return isBlank(0);
}

uint8_t EepromRecord::stored(uint8_t index) const { return eeprom::read(static_cast<uint16_t>(at_ + index)); }

void EepromRecord::store(uint8_t index, uint8_t value) const {
  eeprom::write(static_cast<uint16_t>(at_ + index), value);
}

// Writes all bytes of the seal but those that are right.
void EepromRecord::storeSeals(const Crc16 &crc, uint8_t right) const {
  for (uint8_t i = 0; i < CHECK_LENGTH; i++, right = static_cast<uint8_t>(right >> 1)) {
    if ((right & 1) == 0) store(static_cast<uint8_t>(length_ + i), sealOf(crc, i));
  }
}

bool EepromRecord::isBlank(uint8_t secrets) const {
  for (uint8_t i = 0; i < CHECK_LENGTH; i++) {
    if (stored(static_cast<uint8_t>(length_ + i)) != ERASED) return false;
  }
  for (uint8_t i = 0; i < secrets; i++) {
    if (stored(i) != ERASED) return false;
  }
  return true;
}

bool EepromRecord::holds(const uint8_t *data) const {
  for (uint8_t i = 0; i < length_; i++) {
    if (stored(i) != data[i]) return false;
  }
  return rightSeals(crcOf(data)) == ALL_SEALS;
}

uint8_t EepromRecord::rightSeals(const Crc16 &crc) const {
  uint8_t right = 0;
  uint8_t bit = 1;
  for (uint8_t i = 0; i < CHECK_LENGTH; i++, bit = static_cast<uint8_t>(bit << 1)) {
    if (stored(static_cast<uint8_t>(length_ + i)) == sealOf(crc, i)) right |= bit;
  }
  return right;
}

Crc16 EepromRecord::crcOf(const uint8_t *data) const {
  Crc16 crc;
  crc.add(data, length_);
  return crc;
}

}  // namespace javinolib
