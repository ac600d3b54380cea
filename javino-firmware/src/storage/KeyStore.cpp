#include "KeyStore.h"

#include <stddef.h>
#include <string.h>

#include "../support/Trace.h"
#include "../support/Wipe.h"
#include "Eeprom.h"
#include "EepromLayout.h"

namespace javinolib {

const uint8_t KeyStore::SLOTS;
const uint8_t KeyStore::NO_SLOT;
const uint8_t KeyStore::PLACES;

static_assert(KeyStore::SLOTS == KEY_PLACES, "the layout's number of places");

// A key as EEPROM holds it, with room for its seal.
struct StoredKey {
  Address address;
  uint8_t generation;  // how often the key of its address had been replaced when it came (mod 256)
  uint8_t alone;       // whether it replaces all older ones
  DerivedKeys keys;
  uint8_t seal[EepromRecord::CHECK_LENGTH];

  uint8_t *record() { return reinterpret_cast<uint8_t *>(this); }
};

static_assert(sizeof(StoredKey) == KEY_RECORD_LENGTH, "a record has these bytes as they are");

namespace {

const uint8_t SECRETS_LENGTH = 2 * Aes128::KEY_LENGTH;  // at the end, so that erase() overwrites just them
const uint8_t GENERATION_AT = offsetof(StoredKey, generation);
const uint8_t ALONE_AT = offsetof(StoredKey, alone);
const uint8_t CHECK_AT = offsetof(StoredKey, keys);
const uint8_t UNUSED = 0xFF;
const uint8_t USED = 0;
const uint8_t READINGS = 8;  // that show whether a cell is weak

JAVINO_NOINLINE uint16_t placeAt(uint8_t slot) { return static_cast<uint16_t>(KEYS_AT + slot * KEY_PLACE_LENGTH); }

EepromRecord recordAt(uint8_t slot) { return EepromRecord(placeAt(slot), KEY_LENGTH); }

uint8_t generationAt(uint8_t slot) { return eeprom::read(static_cast<uint16_t>(placeAt(slot) + GENERATION_AT)); }

bool isAlone(uint8_t slot) { return eeprom::read(static_cast<uint16_t>(placeAt(slot) + ALONE_AT)) != 0; }

uint16_t useAt(uint8_t slot) { return static_cast<uint16_t>(placeAt(slot) + KEY_RECORD_LENGTH); }

// Whether the key was set, or taken into use.
bool isUsed(uint8_t slot) { return isAlone(slot) || eeprom::read(useAt(slot)) != UNUSED; }

// Power may have failed while the byte was written, so that it reads now so, now otherwise. Then it becomes what it mostly
// reads as: either will do, as all who share the key accept it.
void settleUse(uint8_t slot) {
  uint8_t unused = 0;
  uint8_t used = 0;
  for (uint8_t i = 0; i < READINGS; i++) {
    const uint8_t reading = eeprom::read(useAt(slot));
    if (reading == UNUSED) unused++;
    if (reading == USED) used++;
  }
  if (unused != READINGS && used != READINGS) eeprom::write(useAt(slot), unused > READINGS / 2 ? UNUSED : USED);
}

// An address has at most three keys at once, so that generations that wrap around are told apart.
bool isNewer(uint8_t slot, uint8_t other) { return static_cast<int8_t>(generationAt(slot) - generationAt(other)) > 0; }

}  // namespace

template <typename Scope>
bool KeyStore::begin() {
  bool any = false;
  sessions_.begin();
  for (uint8_t slot = SLOTS; slot < PLACES; slot++) addresses_[slot] = Address::serialLine();
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    StoredKey stored;
    const bool whole = recordAt(slot).begin(stored.record(), SECRETS_LENGTH);
    addresses_[slot] = whole ? stored.address : Address::serialLine();
    if (Scope::RENEWS && whole) settleUse(slot);
    any |= whole;
  }
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    if (isReplaced<Scope>(slot) && isReplaced<Scope>(slot)) erase(slot);  // twice, as a cell may read wrong once
  }
  return any;
}

// Whether a newer key of the same address replaces this one: an interrupted change has left it.
template <typename Scope>
bool KeyStore::isReplaced(uint8_t slot) const {
  if (!Scope::RENEWS) return !isFree(slot) && current(addressAt(slot)) != slot;
  for (uint8_t other = 0; other < SLOTS; other++) {
    if (!isFree(slot) && addressAt(other) == addressAt(slot) && isNewer(other, slot) && isAlone(other)) return true;
  }
  return false;
}

// The newest that is in use; where none is, the only one. A session key is always the only one.
uint8_t KeyStore::best(const Address &address, uint8_t except) const {
  uint8_t best = NO_SLOT;
  for (uint8_t slot = 0; slot < PLACES; slot++) {
    if (slot == except || addressAt(slot) != address || isFree(slot)) continue;
    if (best == NO_SLOT || (isNewer(slot, best) ? isUsed(slot) : !isUsed(best))) best = slot;
  }
  return best;
}

uint8_t KeyStore::next(const Address &address) const {
  const uint8_t other = this->other(address);
  return other != NO_SLOT && isNewer(other, current(address)) ? other : NO_SLOT;
}

bool KeyStore::loadStored(uint8_t slot, DerivedKeys &into) const {
  StoredKey stored;
  if (slot == NO_SLOT || isFree(slot) || !recordAt(slot).read(stored.record())) return false;
  into = stored.keys;
  return true;
}

bool KeyStore::loadSession(uint8_t slot, DerivedKeys &into) const {
  into.derive(sessions_.keyAt(static_cast<uint8_t>(slot - SLOTS)));
  return !isFree(slot);
}

void KeyStore::readCheckValue(uint8_t slot, uint8_t *check) const {
  if (isSession(slot)) {
    memcpy(check, sessions_.checkAt(static_cast<uint8_t>(slot - SLOTS)), DerivedKeys::CHECK_LENGTH);
    return;
  }
  for (uint8_t i = 0; i < DerivedKeys::CHECK_LENGTH; i++) {
    check[i] = eeprom::read(static_cast<uint16_t>(placeAt(slot) + CHECK_AT + i));
  }
}

template <typename Scope>
Status KeyStore::store(const Address &address, const uint8_t *key, bool renewing) {
  const bool renews = Scope::RENEWS && renewing;
  StoredKey added;
  added.keys.derive(key);
  if (sessions_.had(added.keys.check)) return Status::BAD_ARGUMENT;
  const uint8_t current = this->current(address);
  // If no key is renewed, another one is a key that could not be erased: the next boot tries again.
  const uint8_t other = Scope::RENEWS ? this->other(address) : NO_SLOT;
  const uint8_t next = Scope::RENEWS ? this->next(address) : NO_SLOT;
  const uint8_t stored = isSession(current) ? NO_SLOT : current;
  const bool isOther = Scope::RENEWS && holds(other, added.keys);
  const bool isCurrent = holds(stored, added.keys);
  uint8_t most = config::KEYS;
  if (renews) {
    if (stored == NO_SLOT) return Status::NO_KEY;
    if (isOther ? other == next : isCurrent && next == NO_SLOT) return Status::OK;
    if (other != NO_SLOT) return Status::BAD_ARGUMENT;
  } else {
    // The other key is the current one as soon as it is alone.
    if (isOther) return eraseIfAny(current);
    if (isCurrent) return eraseIfAny(other);
    if (stored != NO_SLOT) most++;  // those that are replaced go
    if (other != NO_SLOT) most++;
  }
  if (count() >= most) return Status::STORE_FULL;
  const uint8_t newest = next == NO_SLOT ? stored : next;
  added.address = address;
  added.generation = newest == NO_SLOT ? 0 : static_cast<uint8_t>(generationAt(newest) + 1);
  added.alone = !renews;
  if (!write(added)) return Status::STORE_FAILED;
  if (renews) return Status::OK;
  const Status erased = eraseIfAny(other);
  return eraseIfAny(current) == Status::OK ? erased : Status::STORE_FAILED;
}

template bool KeyStore::begin<WholeScope>();
template bool KeyStore::begin<UnicastScope>();
template Status KeyStore::store<WholeScope>(const Address &, const uint8_t *, bool);
template Status KeyStore::store<UnicastScope>(const Address &, const uint8_t *, bool);

Status KeyStore::use(const Address &address) {
  const uint8_t slot = next(address);
  if (slot == NO_SLOT) return Status::NO_KEY;
  eeprom::write(useAt(slot), USED);
  return isUsed(slot) ? Status::OK : Status::STORE_FAILED;
}

bool KeyStore::erase(uint8_t slot) {
  if (isSession(slot)) {
    sessions_.erase(static_cast<uint8_t>(slot - SLOTS));
  } else if (!recordAt(slot).erase(SECRETS_LENGTH)) {
    return false;
  }
  addresses_[slot] = Address::serialLine();
  trace::tell(trace::KEY_DELETED, slot);
  return true;
}

bool KeyStore::holds(uint8_t slot, const DerivedKeys &keys) const {
  DerivedKeys present;
  return loadStored(slot, present) && keys.equals(present);
}

// Writes a key to the first free place that keeps it.
bool KeyStore::write(StoredKey &key) {
  for (uint8_t slot = 0; slot < SLOTS; slot++) {
    if (!isFree(slot)) continue;
    if (eeprom::read(useAt(slot)) != UNUSED) eeprom::write(useAt(slot), UNUSED);
    if (eeprom::read(useAt(slot)) == UNUSED && recordAt(slot).write(key.record())) {
      addresses_[slot] = key.address;
      trace::tell(trace::KEY_STORED, slot);
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

}  // namespace javinolib
