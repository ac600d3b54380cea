#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../addressing/Address.h"
#include "../crypto/DerivedKeys.h"
#include "../support/NoInline.h"

namespace javino {

/// The keys that the board shares with devices and groups, in EEPROM (SPEC 4.3, 5.2): for each address the current one,
/// which seals, and while it is being renewed the previous one, which still opens.
///
/// What is stored is not the key but what is derived from it. RAM holds the addresses only.
///
/// A new key is always written to a free place first, for which there is one place more than keys; then what it replaces
/// is erased. Each record has a generation, one higher than the one before it, and says whether it replaces all older
/// ones of its address (set) or all but the last (renew). So a loss of power at any moment leaves the old keys or the new
/// ones: begin() erases what a newer record replaces.
class KeyStore {
 public:
  enum Result : uint8_t {
    STORED,       ///< something has changed
    UNCHANGED,    ///< this key was there already; nothing was written
    IS_PREVIOUS,  ///< a renewal to the previous key, which must not come back so; nothing was written
    FULL,         ///< no place is free; nothing was written
    FAILED        ///< the EEPROM did not keep what was written: the old key stays; or it did not erase the old key
  };

  /// Places, one of which is always free.
  static const uint8_t SLOTS = config::KEYS + 1;
  static const uint8_t NO_SLOT = 0xFF;

  /// Reads the addresses, erases what an interrupted change left over, and overwrites the secrets of what is no whole
  /// record. To be called once, after a boot.
  JAVINO_NOINLINE void begin();

  /// @return the place 0…SLOTS - 1 of the key that seals for a device or multicast address, or NO_SLOT.
  uint8_t current(const Address &address) const { return newest(address, NO_SLOT); }

  /// @return the place of the key that is being replaced and still opens, or NO_SLOT.
  uint8_t previous(const Address &address) const { return newest(address, current(address)); }

  /// The address of a place, or `++++` where it is free.
  const Address &addressAt(uint8_t slot) const { return addresses_[slot]; }

  bool isFree(uint8_t slot) const { return addresses_[slot].isSerial(); }

  /// Reads the key at a place.
  /// @return false where it is NO_SLOT, free or no longer readable.
  JAVINO_NOINLINE bool load(uint8_t slot, DerivedKeys &into) const;

  /// Reads the check value of the key at a place that is not free, without touching its secrets.
  /// @param check room for 3 bytes
  void readCheckValue(uint8_t slot, uint8_t *check) const;

  /// Makes a key of 16 bytes the only one of an address: some 150 ms of EEPROM, and 120 ms for each one that it replaces.
  /// @param address a device or a multicast address
  JAVINO_NOINLINE Result set(const Address &address, const uint8_t *key);

  /// Makes a key the current one, and what was the current one the previous: some 150 ms, and 120 ms where there was a
  /// previous one.
  JAVINO_NOINLINE Result renew(const Address &address, const uint8_t *key);

  /// Forgets the key at a place and overwrites it: some 120 ms.
  /// @return false where the EEPROM still holds it.
  JAVINO_NOINLINE bool erase(uint8_t slot);

 private:
  JAVINO_NOINLINE uint8_t newest(const Address &address, uint8_t except) const;
  bool isReplaced(uint8_t slot) const;
  JAVINO_NOINLINE bool holds(uint8_t slot, const DerivedKeys &keys) const;
  Result add(const Address &address, const DerivedKeys &keys, bool alone);
  bool write(const Address &address, const DerivedKeys &keys, uint8_t generation, bool alone);
  bool eraseIfAny(uint8_t slot) { return slot == NO_SLOT || erase(slot); }
  uint8_t count() const;

  Address addresses_[SLOTS];
};

}  // namespace javino
