#include "DeadBands.h"

#include "../support/Clock.h"

namespace javinolib {

namespace {

// The distance of any two longs, of the greatest and the least too.
unsigned long distance(long one, long other) {
  const unsigned long difference = static_cast<unsigned long>(one) - static_cast<unsigned long>(other);
  return one < other ? 0 - difference : difference;
}

}  // namespace

void DeadBands::begin(bool anew) {
  for (Entry &entry : entries_) {
    if (!entry.seen || (anew && entry.event == NO_EVENT)) entry.name = nullptr;
    entry.seen = false;
  }
}

// The place of a percept that is not in the reading yet, or a free one; null where there is none.
DeadBands::Entry *DeadBands::find(const FlashText *name) {
  Entry *free = nullptr;
  for (Entry &entry : entries_) {
    if (entry.name == name && !entry.seen) return &entry;
    if (entry.name == nullptr) free = &entry;
  }
  return free;
}

long DeadBands::settle(const FlashText *name, long number, unsigned long deadBand, unsigned long leastMillis) {
  const uint32_t now = clock::millis();
  Entry *const entry = find(name);
  if (entry == nullptr) return number;
  if (entry->name == name) {
    const unsigned long change = distance(number, entry->told);
    if (change == 0 || change < deadBand || now - entry->changedAt < leastMillis) {
      entry->seen = true;
      return entry->told;
    }
  }
  *entry = {name, NO_EVENT, true, number, now};
  return number;
}

bool DeadBands::latch(const FlashText *name, bool happens) {
  Entry *const entry = find(name);
  if (entry == nullptr) return happens;
  if (entry->name != name) *entry = {name, IDLE, true, 0, 0};
  entry->seen = true;
  mover_ = moveEvents;
  if (!happens) {
    if (entry->event == KNOWN) entry->event = OVER;
    if (entry->event == MAY_COME) entry->event = GONE;
  } else if (entry->event == IDLE || entry->event == GONE_TOLD) {
    entry->event = WAITING;
  } else if (entry->event == OVER || entry->event == GONE) {
    entry->event = AGAIN;
  }
  return entry->event >= WAITING;
}

bool DeadBands::latch(const FlashText *name, bool happens, long &number) {
  Entry *const entry = find(name);
  if (entry == nullptr) return happens;
  const Event before = entry->name == name ? entry->event : IDLE;
  const bool isOther = entry->told != number;
  latch(name, happens);
  if (happens) {
    const bool hadByHost = before == IDLE || before == OVER || before == KNOWN;
    if (!hadByHost && isOther) counters_->count(Counter::PERCEPTS_LEFT_OUT);
    if (entry->event > WAITING && isOther) entry->event = WAITING;
    entry->told = number;
  }
  number = entry->told;
  return entry->event >= WAITING;
}

void DeadBands::moveEvents(DeadBands &bands, Cause cause) {
  static const uint8_t NEXT[][KNOWN + 1] JAVINO_FLASH = {
      {NO_EVENT, IDLE, IDLE, WAITING, GONE_TOLD, GONE_TOLD, TOLD, TOLD, MAY_COME, KNOWN},
      {NO_EVENT, IDLE, OVER, AGAIN, WAITING, WAITING, WAITING, WAITING, WAITING, KNOWN},
      {NO_EVENT, IDLE, OVER, AGAIN, OVER, IDLE, WAITING, MAY_COME, KNOWN, KNOWN},
      {NO_EVENT, IDLE, OVER, AGAIN, OVER, IDLE, WAITING, KNOWN, KNOWN, KNOWN}};
  for (Entry &entry : bands.entries_) entry.event = static_cast<Event>(flashByte(&NEXT[cause][entry.event]));
}

}  // namespace javinolib
