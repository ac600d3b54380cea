#pragma once

#include <stdint.h>

#include "../framing/Crc16.h"

namespace javino {

/// Some bytes in EEPROM with a CRC behind them, which are either there whole or not there.
///
/// The last byte of the CRC seals the record: it is erased to 0xFF before anything changes and written when all else
/// stands, and 0xFF is never right there. So a loss of power at any moment leaves the old record, the new one or
/// none, and never a mixture.
class EepromRecord {
 public:
  /// What a record takes beyond its data.
  static const uint8_t CHECK_LENGTH = 2;

  /// @param at the first byte in EEPROM
  /// @param length of the data, 1…253 bytes
  EepromRecord(uint16_t at, uint8_t length) : at_(at), length_(length) {}

  /// Copies the data out.
  /// @return false, and the copy is to be thrown away, where there is no whole record.
  bool read(uint8_t *data) const;

  /// Writes the data, unless it is there already.
  /// @return false where the EEPROM did not keep it.
  bool write(const uint8_t *data);

  /// Takes the record away, and overwrites the first `secrets` bytes of its data.
  /// @return false where the EEPROM still holds it.
  bool erase(uint8_t secrets);

 private:
  uint8_t stored(uint8_t index) const;
  void store(uint8_t index, uint8_t value);
  bool holds(const uint8_t *data) const;
  Crc16 crcOf(const uint8_t *data) const;
  bool isSealed(const Crc16 &crc) const;

  uint16_t at_;
  uint8_t length_;
};

}  // namespace javino
