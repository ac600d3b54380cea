#include "KeyStore.h"

#include <string.h>

#include "../support/BigEndian.h"
#include "../support/Wipe.h"
#include "Eeprom.h"
#include "EepromLayout.h"

namespace javino {

const uint8_t KeyStore::SLOTS;
const uint8_t KeyStore::NO_SLOT;

static_assert(KeyStore::SLOTS == KEY_PLACES, "the layout's number of places");

namespace {

const uint8_t SECRETS_LENGTH = 2 * Aes128::KEY_LENGTH;
const uint8_t CHECK_AT = SECRETS_LENGTH;
const uint8_t ADDRESS_AT = CHECK_AT + DerivedKeys::CHECK_LENGTH;
const uint8_t GENERATION_AT = ADDRESS_AT + Address::STORED_LENGTH;
const uint8_t ALONE_AT = GENERATION_AT + 1;

uint16_t placeAt(uint8_t slot) { return static_cast<uint16_t>(KEYS_AT + slot * KEY_RECORD_LENGTH); }

EepromRecord recordAt(uint8_t slot) { return EepromRecord(placeAt(slot), KEY_LENGTH); }

// How often the key of its address had been replaced when this one came (mod 256).
uint8_t generationAt(uint8_t slot) { return eeprom::read(static_cast<uint16_t>(placeAt(slot) + GENERATION_AT)); }

// Whether the key replaces all older ones, and not all but one.
bool isAlone(uint8_t slot) { return eeprom::read(static_cast<uint16_t>(placeAt(slot) + ALONE_AT)) != 0; }

// An address has at most three keys at once, so that generations that wrap around are told apart.
bool isNewer(uint8_t slot, uint8_t other) { return static_cast<int8_t>(generationAt(slot) - generationAt(other)) > 0; }

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
    const bool whole = recordAt(slot).begin(stored.bytes, SECRETS_LENGTH);
    addresses_[slot] = whole ? stored.address() : Address::serialLine();
  }
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    if (isReplaced(slot) && isReplaced(slot)) erase(slot);  // twice, as a cell may read wrong once
  }
}

// Whether a newer key of the same address replaces this one: an interrupted change has left it.
bool KeyStore::isReplaced(uint8_t slot) const {
  uint8_t newer = 0;
  for (uint8_t other = 0; other < SLOTS; other++) {
    if (isFree(slot) || addresses_[other] != addresses_[slot] || !isNewer(other, slot)) continue;
    newer = static_cast<uint8_t>(newer + (isAlone(other) ? 2 : 1));
  }
  return newer >= 2;
}

uint8_t KeyStore::newest(const Address &address, uint8_t except) const {
  uint8_t newest = NO_SLOT;
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    if (slot == except || addresses_[slot] != address || isFree(slot)) continue;
    if (newest == NO_SLOT || isNewer(slot, newest)) newest = slot;
  }
  return newest;
}

bool KeyStore::load(uint8_t slot, DerivedKeys &into) const {
  StoredKey stored;
  if (slot == NO_SLOT || isFree(slot) || !recordAt(slot).read(stored.bytes)) return false;
  stored.unpack(into);
  return true;
}

void KeyStore::readCheckValue(uint8_t slot, uint8_t *check) const {
  for (uint8_t i = 0; i < DerivedKeys::CHECK_LENGTH; i++) {
    check[i] = eeprom::read(static_cast<uint16_t>(placeAt(slot) + CHECK_AT + i));
  }
}

KeyStore::Result KeyStore::set(const Address &address, const uint8_t *key) {
  DerivedKeys keys;
  keys.derive(key);
  const uint8_t current = this->current(address);
  const uint8_t previous = this->previous(address);
  if (holds(current, keys)) {
    if (previous == NO_SLOT) return UNCHANGED;
    return erase(previous) ? STORED : FAILED;
  }
  // The previous key is current again as soon as its successor is gone.
  if (holds(previous, keys)) return erase(current) ? STORED : FAILED;
  const Result result = add(address, keys, true);
  if (result != STORED) return result;
  const bool erased = eraseIfAny(previous);
  return eraseIfAny(current) && erased ? STORED : FAILED;
}

KeyStore::Result KeyStore::renew(const Address &address, const uint8_t *key) {
  DerivedKeys keys;
  keys.derive(key);
  const uint8_t previous = this->previous(address);
  if (holds(current(address), keys)) return UNCHANGED;
  if (holds(previous, keys)) return IS_PREVIOUS;
  const Result result = add(address, keys, false);
  if (result != STORED) return result;
  return eraseIfAny(previous) ? STORED : FAILED;
}

bool KeyStore::erase(uint8_t slot) {
  const bool erased = recordAt(slot).erase(SECRETS_LENGTH);
  if (erased) addresses_[slot] = Address::serialLine();
  return erased;
}

bool KeyStore::holds(uint8_t slot, const DerivedKeys &keys) const {
  DerivedKeys present;
  return load(slot, present) && keys.equals(present);
}

// Adds the newest key of an address, if there will not be too many when those are gone that it replaces.
KeyStore::Result KeyStore::add(const Address &address, const DerivedKeys &keys, bool alone) {
  const uint8_t current = this->current(address);
  uint8_t count = this->count();
  if (alone && current != NO_SLOT) count--;
  if (previous(address) != NO_SLOT) count--;
  if (count >= config::KEYS) return FULL;
  const uint8_t generation = current == NO_SLOT ? 0 : static_cast<uint8_t>(generationAt(current) + 1);
  return write(address, keys, generation, alone) ? STORED : FAILED;
}

// Writes a key to the first free place that keeps it.
bool KeyStore::write(const Address &address, const DerivedKeys &keys, uint8_t generation, bool alone) {
  StoredKey stored;
  stored.pack(address, keys);
  stored.bytes[GENERATION_AT] = generation;
  stored.bytes[ALONE_AT] = alone;
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    if (!isFree(slot)) continue;
    if (recordAt(slot).write(stored.bytes)) {
      addresses_[slot] = address;
      return true;
    }
    recordAt(slot).erase(SECRETS_LENGTH);
  }
  return false;
}

uint8_t KeyStore::count() const {
  uint8_t count = 0;
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    if (!isFree(slot)) count++;
  }
  return count;
}

}  // namespace javino
