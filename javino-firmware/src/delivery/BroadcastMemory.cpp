#include "BroadcastMemory.h"

#include "../support/Crc16.h"

namespace javinolib {

const uint8_t BroadcastMemory::CAPACITY;

static const uint16_t REPEAT_MILLIS = 400;

bool BroadcastMemory::isRepeat(const uint8_t *frame, Length length, uint32_t now, uint16_t age) {
  Crc16 crc;
  crc.add(frame, length);
  bool repeat = false;
  Entry *place = nullptr;
  for (Entry &entry : entries_) {
    if (entry.crc == crc.value()) place = &entry;
  }
  if (place) {
    // A broadcast that began before the other ended, as fragments may, is in time too; one that seems to have begun more than a
    // minute before is not.
    repeat = (place->repeatsUntil - (now - age)) >> 16 == 0;
  } else {
    place = &entries_[oldest_];
    oldest_ = static_cast<uint8_t>(oldest_ + 1 < CAPACITY ? oldest_ + 1 : 0);
  }
  place->crc = crc.value();
  place->repeatsUntil = now + REPEAT_MILLIS;
  return repeat;
}

}  // namespace javinolib
