#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Address.h"
#include "../support/Status.h"
#include "../crypto/DerivedKeys.h"
#include "../support/Inlining.h"
#include "../support/Part.h"
#include "../support/Scope.h"
#include "../support/Trace.h"
#include "SessionKeys.h"

namespace javinolib {

struct StoredKey;

/// The keys that the board shares with devices and groups, in EEPROM (SPEC 4.3, 5.2): for each address the current one,
/// which seals, and while it is being renewed another one, which opens only: the next key, or the previous one. A device
/// without such a key may have a session key, which is in RAM only.
///
/// What EEPROM stores is not the key but what is derived from it. RAM holds the addresses, and the session keys.
///
/// A new key is always written to a free place first, for which there is one place more than keys; then what it replaces
/// is erased. Each record has a generation, one higher than the one before it, and says whether it replaces all older
/// ones of its address (set): begin() erases what a newer record replaces.
///
/// Behind each record is one byte, which is 0xFF until a renewed key is taken into use. Of two keys the newer one that is
/// in use seals. So a loss of power at any moment, also while that byte is written, leaves the old keys or the new ones.
class KeyStore {
 public:
  /// Places, one of which is always free.
  static const uint8_t SLOTS = config::KEYS + 1;
  static const uint8_t NO_SLOT = 0xFF;

  /// The places of session keys follow.
  static const uint8_t PLACES = SLOTS + SessionKeys::PLACES;

  /// Whether a place is one of a session key.
  static bool isSession(uint8_t slot) { return SessionKeys::PLACES != 0 && slot >= SLOTS && slot != NO_SLOT; }

  /// Reads the addresses, erases what an interrupted change left over, and overwrites the secrets of what is no whole
  /// record. To be called once, after a boot.
  /// Where keys are not renewed, it breaks off what another sketch has begun: the key in use stays.
  /// @return whether there is a key
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE bool begin();

  /// @return the place 0…PLACES - 1 of the key that seals for a device or multicast address, or NO_SLOT.
  uint8_t current(const Address &address) const { return best(address, NO_SLOT); }

  /// @return the place of the key that opens beside the current one while that is being renewed, or NO_SLOT.
  uint8_t other(const Address &address) const { return best(address, current(address)); }

  /// The most keys that an address has.
  static const uint8_t KEYS_OF_ADDRESS = 2;

  /// @return the other key's place where that is to be the current one, and NO_SLOT where it was.
  JAVINO_NOINLINE uint8_t next(const Address &address) const;

  /// The address of a place, or `++++` where it is free.
  JAVINO_NOINLINE const Address &addressAt(uint8_t slot) const { return addresses_[slot]; }

  JAVINO_NOINLINE bool isFree(uint8_t slot) const { return addressAt(slot).isSerial(); }

  /// Reads the key at a place.
  /// @return false where it is NO_SLOT, free or no longer readable.
  bool load(uint8_t slot, DerivedKeys &into) const {
    return isSession(slot) ? loadSession(slot, into) : loadStored(slot, into);
  }

  /// Reads the check value of the key at a place that is not free, without touching its secrets.
  /// @param check room for 3 bytes
  void readCheckValue(uint8_t slot, uint8_t *check) const;

  /// Makes a key of 16 bytes the only one of an address: some 150 ms of EEPROM, and 120 ms for each one that it replaces.
  /// @param address a device or a multicast address
  /// @return OK; BAD_ARGUMENT where it is or was a session key, STORE_FULL, and nothing was written; STORE_FAILED, and the old key stays, or was not erased
  Status set(const Address &address, const uint8_t *key) { return store(address, key, false); }

  /// Makes a key the next one of an address: some 150 ms.
  /// @return OK; NO_KEY where there is none in EEPROM to be renewed, BAD_ARGUMENT where another renewal is not finished or
  ///         it is or was a session key, STORE_FULL, and nothing was written; STORE_FAILED
  Status renew(const Address &address, const uint8_t *key) { return store(address, key, true); }

  /// One of the two above.
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE Status store(const Address &address, const uint8_t *key, bool renews);

  /// Makes the next key the current one, and what was the current one the previous: 3.4 ms.
  /// @return OK, NO_KEY where there is no next one, or STORE_FAILED
  Status use(const Address &address);

  /// Puts a session key into a place that is free.
  /// @param slot one of a session key
  void setSession(uint8_t slot, const Address &device, const uint8_t *key, const uint8_t *check) {
    if (SessionKeys::PLACES == 0) return;
    sessions_.set(static_cast<uint8_t>(slot - SLOTS), key, check);
    addresses_[slot] = device;
    trace::tell(trace::KEY_STORED, slot);
  }

  /// The session keys, by their places less SLOTS.
  const SessionKeys &sessions() const { return sessions_; }

  /// A message was sealed or opened with the key at a place.
  void used(uint8_t slot) {
    if (SessionKeys::PLACES > 1 && isSession(slot)) sessions_.use(static_cast<uint8_t>(slot - SLOTS));
  }

  /// Forgets the key at a place and overwrites it: in EEPROM some 120 ms.
  /// @return false where the EEPROM still holds it.
  JAVINO_NOINLINE bool erase(uint8_t slot);

 private:
  JAVINO_NOINLINE uint8_t best(const Address &address, uint8_t except) const;
  template <typename Scope>
  bool isReplaced(uint8_t slot) const;
  JAVINO_NOINLINE bool loadStored(uint8_t slot, DerivedKeys &into) const;
  JAVINO_NOINLINE bool loadSession(uint8_t slot, DerivedKeys &into) const;
  JAVINO_NOINLINE bool holds(uint8_t slot, const DerivedKeys &keys) const;
  bool write(StoredKey &key);
  JAVINO_NOINLINE Status eraseIfAny(uint8_t slot) {
    return slot == NO_SLOT || erase(slot) ? Status::OK : Status::STORE_FAILED;
  }
  uint8_t count() const;

  Address addresses_[PLACES];
  SessionKeys sessions_;
};

#ifdef __AVR__
template <>
KeyStore &Part<KeyStore>::the();
template <>
const KeyStore &Part<const KeyStore>::the();
#endif

}  // namespace javinolib
