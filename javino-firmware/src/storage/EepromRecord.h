#pragma once

#include <stdint.h>

#include "../support/Inlining.h"

namespace javinolib {

/// Some bytes in EEPROM with a check behind them, which are either there whole or not there. In RAM too there is room for the
/// check behind them.
///
/// The check is three bytes, the seal, made of a CRC; none of them is ever 0xFF. A record is there where two of the three
/// are right. They are erased to 0xFF, the last one first, before anything changes, and written, the first one first, when
/// all else stands. So a loss of power at any moment leaves the old record, the new one or none, and never a mixture.
///
/// A cell that power failed in is weak: it may read now as what it was, now as what it was to be. Of the data it does no
/// harm, as nothing is sealed yet, and write() writes each cell anew, however it reads. Of a seal it is one of three: the
/// two others decide, or begin() does, which mends the seal or erases it. From then on the record is there or not, whatever
/// the weak cell reads.
class EepromRecord {
 public:
  /// The bytes that a record takes beyond its data.
  static const uint8_t CHECK_LENGTH = 3;

  /// @param at the first byte in EEPROM
  /// @param length of the data, 1…253 bytes
  EepromRecord(uint16_t at, uint8_t length) : at_(at), length_(length) {}

  /// Does what is to be done once after a boot, before the record is relied on: copies the data out, and mends what a loss
  /// of power has left half done. What is no whole record is read twice, then erased.
  /// @param secrets as for erase()
  /// @return as read()
  JAVINO_INLINE bool begin(uint8_t *data, uint8_t secrets) const { return begin(at_, length_, data, secrets); }

  /// Copies the data out.
  /// @return false, and the copy is to be thrown away, where there is no whole record.
  JAVINO_INLINE bool read(uint8_t *data) const { return read(at_, length_, data); }

  /// Writes the data, unless it is there already.
  /// @return false where the EEPROM did not keep it: then no record is there.
  JAVINO_INLINE bool write(uint8_t *data) const { return write(at_, length_, data); }

  /// Takes the record away, and overwrites the last `secrets` bytes of its data. Writes nothing where all that is blank.
  /// @return false where the EEPROM still holds it.
  JAVINO_INLINE bool erase(uint8_t secrets) const { return erase(at_, length_, secrets); }

 private:
  JAVINO_NOINLINE static bool begin(uint16_t at, uint8_t length, uint8_t *data, uint8_t secrets);
  JAVINO_NOINLINE static bool read(uint16_t at, uint8_t length, uint8_t *data);
  JAVINO_NOINLINE static bool write(uint16_t at, uint8_t length, uint8_t *data);
  JAVINO_NOINLINE static bool erase(uint16_t at, uint8_t length, uint8_t secrets);

  uint16_t at_;
  uint8_t length_;
};

}  // namespace javinolib
