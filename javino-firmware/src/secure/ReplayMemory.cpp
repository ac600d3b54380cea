#include "ReplayMemory.h"

#include <string.h>

#include "../support/BigEndian.h"

namespace javino {

const uint8_t ReplayMemory::FREE;
const uint8_t ReplayMemory::NO_ENTRY;

ReplayMemory::ReplayMemory() {
  for (uint8_t i = 0; i < config::REPLAY_ENTRIES; i++) entries_[i].key = FREE;
}

ReplayMemory::Verdict ReplayMemory::judge(uint8_t key, Address origin, const uint8_t *nonce) const {
  const uint8_t known = find(key, origin);
  if (known == NO_ENTRY) return findFree() == NO_ENTRY ? FULL : NEWER;
  return memcmp(nonce, entries_[known].nonce, NONCE_LENGTH) > 0 ? NEWER : REPLAYED;
}

void ReplayMemory::remember(uint8_t key, Address origin, const uint8_t *nonce) {
  const uint8_t known = find(key, origin);
  Entry &entry = entries_[known == NO_ENTRY ? findFree() : known];
  entry.key = key;
  writeUint24(entry.origin, origin.value());
  memcpy(entry.nonce, nonce, NONCE_LENGTH);
}

void ReplayMemory::forget(uint8_t key) {
  for (uint8_t i = 0; i < config::REPLAY_ENTRIES; i++) {
    if (entries_[i].key == key) entries_[i].key = FREE;
  }
}

uint8_t ReplayMemory::find(uint8_t key, Address origin) const {
  for (uint8_t i = 0; i < config::REPLAY_ENTRIES; i++) {
    if (entries_[i].key == key && readUint24(entries_[i].origin) == origin.value()) return i;
  }
  return NO_ENTRY;
}

uint8_t ReplayMemory::findFree() const {
  for (uint8_t i = 0; i < config::REPLAY_ENTRIES; i++) {
    if (entries_[i].key == FREE) return i;
  }
  return NO_ENTRY;
}

}  // namespace javino
