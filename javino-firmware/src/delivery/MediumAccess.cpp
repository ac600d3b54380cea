#include "MediumAccess.h"

#include "../support/Clock.h"
#include "../support/Counters.h"
#include "../support/Trace.h"

namespace javinolib {

// A radio may know what it can do only once it has begun.
bool MediumAccess::begin() {
  const bool begun = radio_.begin();
  slotMillis_ = radio_.slotMillis();
  fragmentLength_ = static_cast<uint8_t>(radio_.longestPayload() - HEADER_LENGTH);
  return begun;
}

void MediumAccess::update() {
  const uint16_t now = static_cast<uint16_t>(clock::millis());
  const bool wasBusy = isBusy();
  carrier_ = radio_.carrier();
  sending_ = radio_.sending();
  trace::tell(static_cast<trace::Point>(trace::QUIET + isBusy()));
  const uint16_t elapsed = static_cast<uint16_t>(now - lookedAt_);
  lookedAt_ = now;
  quietMillis_ = 0;
  if (isBusy() || wasBusy) {
    quietSlots_ = 0;
    slotSince_ = now;
    return;
  }
  quietMillis_ = static_cast<uint8_t>(elapsed > UINT8_MAX ? UINT8_MAX : elapsed);
  for (; static_cast<uint16_t>(now - slotSince_) >= slotMillis_;
       slotSince_ = static_cast<uint16_t>(slotSince_ + slotMillis_)) {
    quietSlots_ = slotAfter(quietSlots_);
  }
}

bool MediumAccess::send(const uint8_t *payload, uint8_t length, Trailer trailer) {
  Radio &radio = radio_;
  uint8_t lasts = length;
#if JAVINO_LARGE
  lasts = static_cast<uint8_t>(lasts + radio.follow(trailer, length));
#else
  (void)trailer;
#endif
  if (!radio.send(payload, length)) return false;
  uint16_t millis = radio.airtimeMillis(lasts);
  millis = static_cast<uint16_t>(millis + airtimeMillis_);
  for (; millis >= 1000; millis = static_cast<uint16_t>(millis - 1000)) countUp(airtime_);
  airtimeMillis_ = millis;
  sending_ = true;
  quietSlots_ = 0;
  return true;
}

bool MediumAccess::sendCopy(const uint8_t *payload, uint8_t length, uint8_t path, Trailer trailer) {
  uint8_t &told = *radio_.sentPath();
  told = path;
  const bool sent = send(payload, length, trailer);
  told = 0;
  return sent;
}

}  // namespace javinolib
