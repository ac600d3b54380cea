#include "KeyStore.h"

#include <string.h>

#include "../support/BigEndian.h"
#include "../support/Wipe.h"
#include "Eeprom.h"
#include "EepromLayout.h"

namespace javino {

const uint8_t KeyStore::SLOTS;
const uint8_t KeyStore::NO_SLOT;

namespace {

const uint8_t SECRETS_LENGTH = 2 * Aes128::KEY_LENGTH;
const uint8_t CHECK_AT = SECRETS_LENGTH;
const uint8_t ADDRESS_AT = CHECK_AT + DerivedKeys::CHECK_LENGTH;

EepromRecord recordAt(uint8_t slot) {
  return EepromRecord(static_cast<uint16_t>(KEYS_AT + slot * KEY_RECORD_LENGTH), KEY_LENGTH);
}

// A key as EEPROM holds it: secrets first, so that erase() can overwrite just them.
struct StoredKey {
  uint8_t bytes[KEY_LENGTH];

  ~StoredKey() { wipe(bytes, sizeof bytes); }

  void pack(const Address &address, const DerivedKeys &keys) {
    memcpy(bytes, keys.encryption, Aes128::KEY_LENGTH);
    memcpy(bytes + Aes128::KEY_LENGTH, keys.authentication, Aes128::KEY_LENGTH);
    memcpy(bytes + CHECK_AT, keys.check, DerivedKeys::CHECK_LENGTH);
    writeUint24(bytes + ADDRESS_AT, address.value());
  }

  void unpack(DerivedKeys &keys) const {
    memcpy(keys.encryption, bytes, Aes128::KEY_LENGTH);
    memcpy(keys.authentication, bytes + Aes128::KEY_LENGTH, Aes128::KEY_LENGTH);
    memcpy(keys.check, bytes + CHECK_AT, DerivedKeys::CHECK_LENGTH);
  }

  Address address() const { return Address(readUint24(bytes + ADDRESS_AT)); }
};

}  // namespace

void KeyStore::begin() {
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    StoredKey stored;
    addresses_[slot] = recordAt(slot).read(stored.bytes) ? stored.address() : Address::serialLine();
  }
}

uint8_t KeyStore::find(const Address &address) const {
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    if (addresses_[slot] == address && !address.isSerial()) return slot;
  }
  return NO_SLOT;
}

bool KeyStore::load(uint8_t slot, DerivedKeys &into) const {
  StoredKey stored;
  if (addresses_[slot].isSerial() || !recordAt(slot).read(stored.bytes)) return false;
  stored.unpack(into);
  return true;
}

void KeyStore::readCheckValue(uint8_t slot, uint8_t *check) const {
  const uint16_t at = static_cast<uint16_t>(KEYS_AT + slot * KEY_RECORD_LENGTH + CHECK_AT);
  for (uint8_t i = 0; i < DerivedKeys::CHECK_LENGTH; i++) check[i] = eeprom::read(static_cast<uint16_t>(at + i));
}

KeyStore::Result KeyStore::set(const Address &address, const uint8_t *key) {
  const uint8_t slot = placeFor(address);
  if (slot == NO_SLOT) return FULL;
  DerivedKeys derived;
  derived.derive(key);
  DerivedKeys present;
  if (load(slot, present) && derived.equals(present)) return UNCHANGED;

  StoredKey stored;
  stored.pack(address, derived);
  const bool kept = recordAt(slot).write(stored.bytes);
  addresses_[slot] = kept ? address : Address::serialLine();
  return kept ? STORED : FAILED;
}

bool KeyStore::erase(uint8_t slot) {
  const bool erased = recordAt(slot).erase(SECRETS_LENGTH);
  if (erased) addresses_[slot] = Address::serialLine();
  return erased;
}

uint8_t KeyStore::placeFor(const Address &address) const {
  const uint8_t present = find(address);
  if (present != NO_SLOT) return present;
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    if (addresses_[slot].isSerial()) return slot;
  }
  return NO_SLOT;
}

}  // namespace javino
