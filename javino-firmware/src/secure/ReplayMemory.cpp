#include "ReplayMemory.h"

#include <string.h>

namespace javino {

const uint8_t ReplayMemory::FREE;
const uint8_t ReplayMemory::NO_ENTRY;

ReplayMemory::ReplayMemory() {
  for (uint8_t i = 0; i < config::REPLAY_ENTRIES; i++) entries_[i].key = FREE;
}

ReplayMemory::Verdict ReplayMemory::judge(uint8_t key, const Address &origin, const uint8_t *nonce) const {
  const uint8_t place = placeFor(key, origin);
  if (place == NO_ENTRY) return FULL;
  const Entry &entry = entries_[place];
  return entry.key == FREE || memcmp(nonce, entry.nonce, NONCE_LENGTH) > 0 ? NEWER : REPLAYED;
}

void ReplayMemory::remember(uint8_t key, const Address &origin, const uint8_t *nonce) {
  Entry &entry = entries_[placeFor(key, origin)];
  entry.key = key;
  entry.origin = origin;
  memcpy(entry.nonce, nonce, NONCE_LENGTH);
}

void ReplayMemory::forget(uint8_t key) {
  for (uint8_t i = 0; i < config::REPLAY_ENTRIES; i++) {
    if (entries_[i].key == key) entries_[i].key = FREE;
  }
}

// The place that remembers this origin, else a free one, else NO_ENTRY.
uint8_t ReplayMemory::placeFor(uint8_t key, const Address &origin) const {
  uint8_t place = NO_ENTRY;
  for (uint8_t i = 0; i < config::REPLAY_ENTRIES; i++) {
    const Entry &entry = entries_[i];
    if (entry.key == key && entry.origin == origin) return i;
    if (entry.key == FREE) place = i;
  }
  return place;
}

}  // namespace javino
