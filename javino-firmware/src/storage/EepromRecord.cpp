#include "EepromRecord.h"

#include "Eeprom.h"

namespace javino {

const uint8_t EepromRecord::CHECK_LENGTH;

static const uint8_t ERASED = 0xFF;

// The high byte of the CRC stands first, the low byte last, as the seal.
static uint8_t highOf(const Crc16 &crc) { return static_cast<uint8_t>(crc.value() >> 8); }

static uint8_t sealOf(const Crc16 &crc) {
  const uint8_t low = static_cast<uint8_t>(crc.value());
  return low == ERASED ? 0 : low;
}

bool EepromRecord::read(uint8_t *data) const {
  for (uint8_t i = 0; i < length_; i++) data[i] = stored(i);
  return isSealed(crcOf(data));
}

bool EepromRecord::write(const uint8_t *data) {
  if (holds(data)) return true;
  const Crc16 crc = crcOf(data);
  store(length_ + 1, ERASED);
  for (uint8_t i = 0; i < length_; i++) store(i, data[i]);
  store(length_, highOf(crc));
  store(length_ + 1, sealOf(crc));
  return holds(data);
}

bool EepromRecord::erase(uint8_t secrets) {
  store(length_ + 1, ERASED);
  for (uint8_t i = 0; i < secrets; i++) store(i, ERASED);
  return stored(length_ + 1) == ERASED;
}

uint8_t EepromRecord::stored(uint8_t index) const { return eeprom::read(static_cast<uint16_t>(at_ + index)); }

void EepromRecord::store(uint8_t index, uint8_t value) { eeprom::update(static_cast<uint16_t>(at_ + index), value); }

bool EepromRecord::holds(const uint8_t *data) const {
  for (uint8_t i = 0; i < length_; i++) {
    if (stored(i) != data[i]) return false;
  }
  return isSealed(crcOf(data));
}

Crc16 EepromRecord::crcOf(const uint8_t *data) const {
  Crc16 crc;
  crc.add(data, length_);
  return crc;
}

bool EepromRecord::isSealed(const Crc16 &crc) const {
  return stored(length_) == highOf(crc) && stored(length_ + 1) == sealOf(crc);
}

}  // namespace javino
