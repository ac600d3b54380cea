#include "DeadBands.h"

#include "../support/Clock.h"

namespace javinolib {

namespace {

// Of any two longs, the greatest and the least too.
unsigned long distance(long one, long other) {
  const unsigned long difference = static_cast<unsigned long>(one) - static_cast<unsigned long>(other);
  return one < other ? 0 - difference : difference;
}

}  // namespace

void DeadBands::begin(bool anew) {
  for (Entry *entry = entries_; entry != entries_ + config::DEAD_BANDS; entry++) {
    if (anew || !entry->seen) entry->name = nullptr;
    entry->seen = false;
  }
}

long DeadBands::settle(const FlashText *name, long number, unsigned long deadBand, unsigned long leastMillis) {
  const uint32_t now = clock::millis();
  Entry *free = nullptr;
  for (Entry *entry = entries_; entry != entries_ + config::DEAD_BANDS; entry++) {
    if (entry->name == nullptr) free = entry;
    if (entry->name != name || entry->seen) continue;
    entry->seen = true;
    const unsigned long change = distance(number, entry->told);
    if (change == 0 || change < deadBand || now - entry->changedAt < leastMillis) return entry->told;
    free = entry;
    break;
  }
  if (free != nullptr) *free = {name, true, number, now};
  return number;
}

}  // namespace javinolib
