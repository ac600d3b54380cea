#include "EepromRecord.h"

#include "../framing/Crc16.h"

namespace javino {

const uint8_t EepromRecord::CHECK_LENGTH;

static const uint8_t ERASED = 0xFF;

// The high byte of the CRC stands first, the low byte last, as the seal.
static uint8_t highOf(const Crc16 &crc) { return static_cast<uint8_t>(crc.value() >> 8); }

static uint8_t sealOf(const Crc16 &crc) {
  const uint8_t low = static_cast<uint8_t>(crc.value());
  return low == ERASED ? 0 : low;
}

EepromRecord::State EepromRecord::state() const {
  Crc16 crc;
  for (uint8_t i = 0; i < length_; i++) crc.add(stored(i));
  if (stored(length_) == highOf(crc) && eeprom_.read(sealAt()) == sealOf(crc)) return VALID;
  return isBlank() ? BLANK : DAMAGED;
}

bool EepromRecord::read(uint8_t *data) const {
  for (uint8_t i = 0; i < length_; i++) data[i] = stored(i);
  return holds(data);
}

bool EepromRecord::write(const uint8_t *data) {
  if (holds(data)) return true;
  Crc16 crc;
  crc.add(data, length_);
  eeprom_.update(sealAt(), ERASED);
  for (uint8_t i = 0; i < length_; i++) eeprom_.update(static_cast<uint16_t>(at_ + i), data[i]);
  eeprom_.update(static_cast<uint16_t>(at_ + length_), highOf(crc));
  eeprom_.update(sealAt(), sealOf(crc));
  return holds(data);
}

bool EepromRecord::erase(uint8_t secrets) {
  eeprom_.update(sealAt(), ERASED);
  for (uint8_t i = 0; i < secrets; i++) eeprom_.update(static_cast<uint16_t>(at_ + i), ERASED);
  return state() != VALID;
}

bool EepromRecord::holds(const uint8_t *data) const {
  Crc16 crc;
  for (uint8_t i = 0; i < length_; i++) {
    if (stored(i) != data[i]) return false;
    crc.add(data[i]);
  }
  return stored(length_) == highOf(crc) && eeprom_.read(sealAt()) == sealOf(crc);
}

bool EepromRecord::isBlank() const {
  for (uint16_t at = at_; at <= sealAt(); at++) {
    if (eeprom_.read(at) != ERASED) return false;
  }
  return true;
}

}  // namespace javino
