#include "IgnoredMessages.h"

namespace javinolib {

const uint8_t IgnoredMessages::CAPACITY;
const uint8_t IgnoredMessages::FREE;
const uint8_t IgnoredMessages::USED;

void IgnoredMessages::add(const Address &origin, uint8_t id, uint16_t now) {
  Entry *entry = find(origin, id);
  if (entry == nullptr) {
    entry = &entries_[oldest_];
    oldest_ = static_cast<uint8_t>((oldest_ + 1) % CAPACITY);
  }
  entry->origin = origin;
  entry->mark = static_cast<uint8_t>(id | USED);
  entry->lastFragment = now;
}

void IgnoredMessages::remove(const Address &origin, uint8_t id) {
  Entry *entry = find(origin, id);
  if (entry != nullptr) entry->mark = FREE;
}

bool IgnoredMessages::covers(const Address &origin, uint8_t id, uint16_t now) {
  Entry *entry = find(origin, id);
  if (entry == nullptr) return false;
  entry->lastFragment = now;
  return true;
}

void IgnoredMessages::expire(uint16_t now, uint16_t after) {
  for (Entry &entry : entries_) {
    if (static_cast<uint16_t>(now - entry.lastFragment) >= after) entry.mark = FREE;
  }
}

IgnoredMessages::Entry *IgnoredMessages::find(const Address &origin, uint8_t id) {
  for (Entry &entry : entries_) {
    if (entry.mark == (id | USED) && entry.origin == origin) return &entry;
  }
  return nullptr;
}

}  // namespace javinolib
