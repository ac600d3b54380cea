#include "BroadcastMemory.h"

#include "../support/Crc16.h"

namespace javinolib {

const uint8_t BroadcastMemory::CAPACITY;

static const uint16_t REPEAT_MILLIS = 400;

bool BroadcastMemory::isRepeat(const Address &origin, const uint8_t *frame, uint16_t length, uint32_t now,
                               uint16_t age) {
  Crc16 crc;
  crc.add(frame, length);
  Entry &entry = placeFor(origin);
  // What began before the other ended, as pieces may, is in time too; what seems to have begun more than a minute before, not.
  const uint32_t left = entry.repeatsUntil - (now - age);
  const bool repeat = left >> 16 == 0 && entry.origin == origin && entry.crc == crc.value();
  entry.origin = origin;
  entry.crc = crc.value();
  entry.repeatsUntil = now + REPEAT_MILLIS;
  return repeat;
}

BroadcastMemory::Entry &BroadcastMemory::placeFor(const Address &origin) {
  for (Entry &entry : entries_) {
    if (entry.origin == origin) return entry;
  }
  Entry &place = entries_[oldest_];
  oldest_ = static_cast<uint8_t>(oldest_ + 1 < CAPACITY ? oldest_ + 1 : 0);
  return place;
}

}  // namespace javinolib
