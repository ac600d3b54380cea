#include "BroadcastMemory.h"

#include "../support/Crc16.h"

namespace javinolib {

const uint8_t BroadcastMemory::CAPACITY;

static const uint16_t REPEAT_MILLIS = 400;
static const uint16_t LONGEST_MILLIS = 0xFFFF;  // from a message's first piece to its last, and more

bool BroadcastMemory::isRepeat(const Address &origin, const uint8_t *frame, uint16_t length, uint32_t begun,
                               uint32_t now) {
  Crc16 crc;
  crc.add(frame, length);
  Entry &entry = placeFor(origin);
  // What began before the other ended, as pieces may, is within 400 ms too; what seems to have begun weeks before, after.
  const bool soon = begun - entry.ended + LONGEST_MILLIS <= static_cast<uint32_t>(LONGEST_MILLIS) + REPEAT_MILLIS;
  const bool repeat = soon && entry.origin == origin && entry.crc == crc.value();
  entry.origin = origin;
  entry.crc = crc.value();
  entry.ended = now;
  return repeat;
}

BroadcastMemory::Entry &BroadcastMemory::placeFor(const Address &origin) {
  for (Entry &entry : entries_) {
    if (entry.origin == origin) return entry;
  }
  Entry &place = entries_[oldest_];
  oldest_ = static_cast<uint8_t>((oldest_ + 1) % CAPACITY);
  return place;
}

}  // namespace javinolib
