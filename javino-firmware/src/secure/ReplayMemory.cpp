#include "ReplayMemory.h"

#include "BoardState.h"

#include <string.h>

#include "../storage/EepromLayout.h"
#include "../support/BigEndian.h"
#include "../support/Trace.h"

namespace javinolib {

const uint8_t ReplayMemory::NO_PLACE;

// A floor as EEPROM holds it, with room for its seal.
struct Floor : OriginNonce {
  uint8_t seal[EepromRecord::CHECK_LENGTH];

  uint8_t *record() { return &key; }
};

static_assert(sizeof(Floor) == FLOOR_RECORD_LENGTH, "a record has these bytes as they are");

namespace {

const uint8_t COUNTER_AT = 3;       // in a nonce
const uint8_t MORE_PER_WRITE = 31;  // how far a floor is set above the nonce that it is written for
const uint32_t LAST_COUNTER = 0xFFFFFF;

JAVINO_NOINLINE uint16_t placeAt(uint8_t place) {
  return static_cast<uint16_t>(FLOORS_AT + place * FLOOR_PLACE_LENGTH);
}

EepromRecord recordAt(uint8_t place, uint8_t copy) {
  return EepromRecord(static_cast<uint16_t>(placeAt(place) + copy * FLOOR_RECORD_LENGTH), FLOOR_LENGTH);
}

// Reads the floor at a place; false where there is none.
JAVINO_NOINLINE bool read(uint8_t place, Floor &floor) {
  return recordAt(place, 0).read(floor.record()) || recordAt(place, 1).read(floor.record());
}

// The same once after a boot: both copies are there afterwards, or none.
bool beginPlace(uint8_t place, Floor &floor) {
  Floor second;
  const bool hasFirst = recordAt(place, 0).begin(floor.record(), 0);
  const bool hasSecond = recordAt(place, 1).begin(second.record(), 0);
  if (!hasFirst && hasSecond) floor = second;
  if (hasFirst != hasSecond) recordAt(place, hasFirst).write(floor.record());
  return hasFirst || hasSecond;
}

bool write(uint8_t place, Floor &floor) {
  return recordAt(place, 0).write(floor.record()) && recordAt(place, 1).write(floor.record());
}

JAVINO_NOINLINE bool erase(uint8_t place) {
  const bool first = recordAt(place, 0).erase(0);
  return recordAt(place, 1).erase(0) && first;
}

}  // namespace

bool ReplayMemory::begin(uint32_t epoch) {
  if (!retained::isClear()) return false;  // to write there would destroy the stack
  const bool clear = takeOverRam(epoch);
  readFloors();
  retained::beginEpoch(epoch);
  forgetLostKeys();
  beginRing(epoch);
  return clear;
}

// Keeps what the boot before has left in RAM, or nothing; the floors' places are read anew in any case. Returns false where
// that boot is known to have run over the canary: after a loss of power its epoch is hardly there.
bool ReplayMemory::takeOverRam(uint32_t epoch) {
  const bool isNext = memory().epoch + 1 == epoch;
  const bool intact = isNext && retained::holds();
  trace::tell(trace::MEMORY, intact);
  for (TakenNonce &entry : memory().entries) {
    if (!intact) entry.state = FREE;
    entry.floor = NO_PLACE;
  }
  return !isNext || retained::hasCanary();
}

// The highest nonce stands where the floor of a pair is missing; with the group as origin, for all that have none there.
template <typename Scope>
void ReplayMemory::doubtFloors() {
  uint8_t highest[NONCE_LENGTH];
  for (uint8_t &byte : highest) byte = 0xFF;
  for (uint8_t key = 0; key < KeyStore::SLOTS; key++) {
    const Address &with = keys_->addressAt(key);
    if (keys_->isFree(key) || find(key, with) != nullptr) continue;
    reserve<Scope>(key, with, highest);
    remember<Scope>(key, with, highest);
  }
}

void ReplayMemory::readFloors() {
  for (uint8_t place = 0; place < config::FLOOR_SLOTS; place++) {
    Floor floor;
    if (!beginPlace(place, floor)) continue;
    if (floor.key < KeyStore::SLOTS && !keys_->isFree(floor.key)) {
      takeOverFloor(place, floor);
    } else {
      erase(place);
    }
  }
}

void ReplayMemory::takeOverFloor(uint8_t place, const OriginNonce &floor) {
  TakenNonce *entry = find(floor.key, floor.origin);
  if (entry == nullptr) {
    entry = findFree(floor.key);
    if (entry == nullptr) return;  // Config.h had room for more when it was written; it stays, and judge() says FULL
    entry->taken = floor;
    entry->state = LOST;
  } else if (entry->floor != NO_PLACE) {  // raised when the power went, and the old one is still there
    Floor other;
    read(entry->floor, other);
    const bool isHigher = memcmp(floor.nonce, other.nonce, NONCE_LENGTH) > 0;
    erase(isHigher ? entry->floor : place);
    if (!isHigher) return;
    if (entry->state == LOST) memcpy(entry->taken.nonce, floor.nonce, NONCE_LENGTH);
  }
  entry->floor = place;
}

// Begins at another free place in each boot: each of them is begun at equally often, however few floors a boot writes.
void ReplayMemory::beginRing(uint32_t epoch) {
  uint8_t free = 0;
  for (uint8_t place = 0; place < config::FLOOR_SLOTS; place++) {
    if (!isInForce(place)) free++;
  }
  uint8_t skipped = static_cast<uint8_t>(static_cast<uint16_t>(epoch) % free);
  uint8_t place = 0;
  while (isInForce(place) || skipped-- != 0) place++;
  nextPlace_ = place;
}

bool ReplayMemory::isDoubtful(uint8_t key) const {
  const TakenNonce *entry = find(key, keys_->addressAt(key));
  return entry != nullptr && entry->state != NOTHING_TAKEN && entry->taken.nonce[0] == 0xFF;
}

template <typename Scope>
ReplayMemory::Verdict ReplayMemory::judge(uint8_t key, const Address &origin, const uint8_t *nonce) const {
  if (!retained::holds()) return DAMAGED;
  const TakenNonce *entry = find(key, origin);
  if (entry == nullptr) return isDoubtful(key) ? REPLAYED : hasRoom<Scope>(key) ? NEWER : FULL;

  const int order = entry->state == NOTHING_TAKEN ? 1 : memcmp(nonce, entry->taken.nonce, NONCE_LENGTH);
  if (order > 0) return NEWER;
  if (entry->state == LOST) return BELOW_FLOOR;
  return order == 0 ? REPEATED : REPLAYED;
}

template <typename Scope>
bool ReplayMemory::reserve(uint8_t key, const Address &origin, const uint8_t *nonce) {
  TakenNonce *entry = find(key, origin);
  if (entry == nullptr ? !hasRoom<Scope>(key) : isCovered(*entry, nonce)) return entry != nullptr;

  Floor floor;
  floor.key = key;
  floor.origin = origin;
  memcpy(floor.nonce, nonce, NONCE_LENGTH);
  uint8_t place = NO_PLACE;
  if (!KeyStore::isSession(key)) {  // one that covers the next nonces of its epoch too
    const uint32_t counter = readUint24(floor.nonce + COUNTER_AT) + MORE_PER_WRITE;
    writeUint24(floor.nonce + COUNTER_AT, counter < LAST_COUNTER ? counter : LAST_COUNTER);
    place = store(floor);
    if (place == NO_PLACE) return false;
    trace::tell(trace::FLOOR_STORED, key, place);
  }

  uint8_t before = NO_PLACE;
  if (entry == nullptr) {
    entry = findFree(key);
    entry->taken = floor;
    entry->state = NOTHING_TAKEN;
  } else {
    before = entry->floor;
  }
  entry->floor = place;
  retained::seal();
  if (before != NO_PLACE) erase(before);  // where it cannot be erased, the higher one counts
  return true;
}

template <typename Scope>
void ReplayMemory::remember(uint8_t key, const Address &origin, const uint8_t *nonce) {
  if (judge<Scope>(key, origin, nonce) != NEWER) return;
  TakenNonce *entry = find(key, origin);
  if (entry == nullptr) return;
  entry->state = EXACT;
  memcpy(entry->taken.nonce, nonce, NONCE_LENGTH);
  retained::seal();
}

void ReplayMemory::floor(uint8_t key, const Address &origin, uint8_t *into) const {
  const TakenNonce *entry = find(key, origin);
  Floor floor;
  if (entry == nullptr || entry->floor == NO_PLACE || !read(entry->floor, floor)) memset(floor.nonce, 0, NONCE_LENGTH);
  memcpy(into, floor.nonce, NONCE_LENGTH);
}

bool ReplayMemory::forget(uint8_t key) {
  bool erased = true;
  for (TakenNonce &entry : memory().entries) {
    if (entry.state == FREE || entry.taken.key != key) continue;
    if (!retained::holds()) break;  // the next boot does it
    entry.state = FREE;
    retained::seal();
    if (entry.floor != NO_PLACE && !erase(entry.floor)) erased = false;
  }
  return erased;
}

bool ReplayMemory::forgetLostKeys() {
  bool erased = true;
  for (uint8_t key = 0; key < KeyStore::PLACES; key++) {
    if (keys_->isFree(key) && !forget(key)) erased = false;
  }
  return erased;
}

TakenNonce *ReplayMemory::find(uint8_t key, const Address &origin) {
  for (TakenNonce &entry : memory().entries) {
    if (entry.state != FREE && entry.taken.key == key && entry.taken.origin == origin) return &entry;
  }
  return nullptr;
}

// Each session key has a place of its own, behind those of the others.
TakenNonce *ReplayMemory::findFree(uint8_t key) {
  TakenNonce *entry = memory().entries;
  if (KeyStore::isSession(key)) {
    entry += config::REPLAY_ENTRIES + (key - KeyStore::SLOTS);
    return entry->state == FREE ? entry : nullptr;
  }
  for (uint8_t left = config::REPLAY_ENTRIES; left != 0; left--, entry++) {
    if (entry->state == FREE) return entry;
  }
  return nullptr;
}

// Whether one more origin of a key may be remembered.
template <typename Scope>
bool ReplayMemory::hasRoom(uint8_t key) const {
  if (!Scope::MANY || !keys_->addressAt(key).isMulticast()) return findFree(key) != nullptr;
  const Groups groups = this->groups(key);
  return groups.origins < groups.places && (groups.own + 1) * groups.keys <= groups.places;
}

ReplayMemory::Groups ReplayMemory::groups(uint8_t ownKey) const {
  Groups groups = {0, config::REPLAY_ENTRIES, 0, 0};
  for (uint8_t key = 0; key < KeyStore::SLOTS; key++) {
    if (keys_->addressAt(key).isMulticast()) {
      groups.keys++;
    } else if (!keys_->isFree(key)) {
      groups.places--;
    }
  }
  for (const TakenNonce &entry : memory().entries) {
    if (entry.state == FREE || !keys_->addressAt(entry.taken.key).isMulticast()) continue;
    groups.origins++;
    if (entry.taken.key == ownKey) groups.own++;
  }
  return groups;
}

bool ReplayMemory::isInForce(uint8_t place) const {
  for (const TakenNonce &entry : memory().entries) {
    if (entry.state != FREE && entry.floor == place) return true;
  }
  return false;
}

// Writes a floor to the next place of the ring that holds none and keeps it; returns the place, or NO_PLACE, also where the
// memory did not hold meanwhile.
uint8_t ReplayMemory::store(Floor &floor) {
  for (uint8_t tries = 0; tries < config::FLOOR_SLOTS; tries++) {
    const uint8_t place = nextPlace_;
    nextPlace_ = static_cast<uint8_t>(place + 1 == config::FLOOR_SLOTS ? 0 : place + 1);
    Floor present;
    if (isInForce(place) || read(place, present)) continue;
    if (write(place, floor)) return retained::holds() ? place : NO_PLACE;
    erase(place);
  }
  return NO_PLACE;
}

bool ReplayMemory::isCovered(const TakenNonce &entry, const uint8_t *nonce) const {
  Floor floor;
  return entry.floor != NO_PLACE && read(entry.floor, floor) && memcmp(nonce, floor.nonce, NONCE_LENGTH) <= 0;
}

template void ReplayMemory::doubtFloors<WholeScope>();
template void ReplayMemory::doubtFloors<UnicastScope>();
template ReplayMemory::Verdict ReplayMemory::judge<WholeScope>(uint8_t, const Address &, const uint8_t *) const;
template ReplayMemory::Verdict ReplayMemory::judge<UnicastScope>(uint8_t, const Address &, const uint8_t *) const;
template void ReplayMemory::remember<WholeScope>(uint8_t, const Address &, const uint8_t *);
template void ReplayMemory::remember<UnicastScope>(uint8_t, const Address &, const uint8_t *);
template bool ReplayMemory::reserve<WholeScope>(uint8_t, const Address &, const uint8_t *);
template bool ReplayMemory::reserve<UnicastScope>(uint8_t, const Address &, const uint8_t *);

}  // namespace javinolib
