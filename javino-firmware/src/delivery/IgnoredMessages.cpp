#include "IgnoredMessages.h"

namespace javino {

const uint8_t IgnoredMessages::CAPACITY;
const uint8_t IgnoredMessages::FREE;

static const uint16_t EXPIRY_MILLIS = 5000;

IgnoredMessages::IgnoredMessages() : oldest_(0) {
  for (uint8_t i = 0; i < CAPACITY; i++) entries_[i].id = FREE;
}

void IgnoredMessages::add(const Address &origin, uint8_t id, uint16_t now) {
  Entry *entry = find(origin, id);
  if (entry == nullptr) {
    entry = &entries_[oldest_];
    oldest_ = static_cast<uint8_t>((oldest_ + 1) % CAPACITY);
  }
  entry->origin = origin;
  entry->id = id;
  entry->lastPiece = now;
}

void IgnoredMessages::remove(const Address &origin, uint8_t id) {
  Entry *entry = find(origin, id);
  if (entry != nullptr) entry->id = FREE;
}

bool IgnoredMessages::covers(const Address &origin, uint8_t id, uint16_t now) {
  Entry *entry = find(origin, id);
  if (entry == nullptr) return false;
  entry->lastPiece = now;
  return true;
}

void IgnoredMessages::expire(uint16_t now) {
  for (uint8_t i = 0; i < CAPACITY; i++) {
    if (static_cast<uint16_t>(now - entries_[i].lastPiece) >= EXPIRY_MILLIS) entries_[i].id = FREE;
  }
}

IgnoredMessages::Entry *IgnoredMessages::find(const Address &origin, uint8_t id) {
  for (uint8_t i = 0; i < CAPACITY; i++) {
    if (entries_[i].id == id && entries_[i].origin == origin) return &entries_[i];
  }
  return nullptr;
}

}  // namespace javino
