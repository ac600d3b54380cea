#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../addressing/Address.h"
#include "../crypto/DerivedKeys.h"
#include "../support/NoInline.h"

namespace javino {

/// The keys that the board shares with devices and groups, in EEPROM (SPEC 4.3, 5.2).
///
/// What is stored is not the key but what is derived from it. RAM holds the addresses only. A loss of power while a
/// key is written leaves the old one or none.
class KeyStore {
 public:
  enum Result : uint8_t {
    STORED,     ///< a key that was not there before, or another one
    UNCHANGED,  ///< this key was there already; nothing was written
    FULL,       ///< no place is free
    FAILED      ///< the EEPROM did not keep what was written; there is no key for this address now
  };

  static const uint8_t SLOTS = config::KEYS;
  static const uint8_t NO_SLOT = 0xFF;

  /// Reads the addresses. To be called once, after a boot.
  void begin();

  /// @return the place 0…SLOTS - 1 of the key for a device or multicast address, or NO_SLOT.
  uint8_t find(const Address &address) const;

  /// The address of a place, or `++++` where it is free.
  const Address &addressAt(uint8_t slot) const { return addresses_[slot]; }

  /// Reads the key at a place.
  /// @return false where it is free or no longer readable.
  JAVINO_NOINLINE bool load(uint8_t slot, DerivedKeys &into) const;

  /// Reads the check value of the key at a place that is not free, without touching its secrets.
  /// @param check room for 3 bytes
  void readCheckValue(uint8_t slot, uint8_t *check) const;

  /// Stores a key of 16 bytes: some 140 ms of EEPROM, unless it is there already.
  /// @param address a device or a multicast address
  JAVINO_NOINLINE Result set(const Address &address, const uint8_t *key);

  /// Forgets the key at a place and overwrites it: some 110 ms.
  /// @return false where the EEPROM still holds it.
  bool erase(uint8_t slot);

 private:
  uint8_t placeFor(const Address &address) const;

  Address addresses_[SLOTS];
};

}  // namespace javino
