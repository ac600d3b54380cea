#include "Poll.h"

#include <string.h>

#include "../support/Clock.h"

namespace javinolib {

namespace {

const uint8_t KNOWN_FLAGS = Poll::PERCEPTS_WANTED | Poll::READING_NOW | Poll::REPLY_LOST | Poll::REPLY_COMING;

// Four bytes a step, the last ones perhaps twice. The chance that a reading has the hash of another one, and so is not told
// after it, is about 1 in four thousand million; the next change is told then. FNV-1a would take AVR five times as long.
uint32_t hash(const uint8_t *bytes, Length length) {
  uint32_t value = length;
  if (length < sizeof value) return bytes[0];
  for (const uint8_t *const last = bytes + length - sizeof value;; bytes += sizeof value) {
    if (bytes > last) bytes = last;
    uint32_t some;
    memcpy(&some, bytes, sizeof some);
    value = (value ^ some) * 0x9E3B;
    value ^= value >> 16;
    if (bytes == last) return value;
  }
}

}  // namespace

const uint8_t Poll::DEFAULT_SAMPLE_MILLIS;

bool Poll::hold(uint8_t flags, uint16_t holdMillis, uint32_t leastMillis) {
  const uint8_t percepts = flags & (PERCEPTS_WANTED | READING_NOW);
  if (flags > KNOWN_FLAGS || percepts == READING_NOW) return false;
  deadBands_.confirm((flags & REPLY_LOST) != 0, (flags & REPLY_COMING) != 0);
  flags_ = flags;
  leastMillis_ = leastMillis;
  endsAt_ = clock::millis() + holdMillis;
  held_ = true;
  if (percepts == 0 || (flags & REPLY_LOST) != 0) told_ = false;
  return true;
}

bool Poll::answer(Reply &reply, bool released) {
  if (!held_) return true;
  const uint32_t now = clock::millis();
  if (!isReadingDue(now, released) || !addReading(now, reply)) {
    if (!released && !isOver(now)) return false;
    reply.add(0);
  }
  held_ = false;
  return true;
}

// Sensors are not read for a poll that is to make room for another request, which may be an action: that must not wait.
bool Poll::isReadingDue(uint32_t now, bool released) const {
  if ((flags_ & PERCEPTS_WANTED) == 0) return false;
  if ((flags_ & READING_NOW) != 0) return true;
  if (released) return false;
  if (!told_) return true;
  return (mayTell(now) || deadBands_.haveEvents()) && (isOver(now) || now - sampledAt_ >= sampleMillis_);
}

// Returns whether the reading is to be told; where not, the reply is as before.
bool Poll::addReading(uint32_t now, Reply &reply) {
  const Length flagsAt = reply.mark();
  reply.add(HAS_READING);
  const bool anew = !told_ || (flags_ & READING_NOW) != 0;
  deadBands_.begin(anew);
  Percepts percepts(reply, deadBands_);
  if (source_ != nullptr) source_(percepts);
  counters_->longest(Counter::PERCEPTS_MILLIS, static_cast<uint16_t>(now));
  if (percepts.leftOut() != 0) reply.replace(flagsAt, HAS_READING | PERCEPTS_OMITTED);
  const uint32_t read = hash(reply.packet() + flagsAt, static_cast<uint16_t>(reply.mark() - flagsAt));
  sampledAt_ = now;
  if (!anew && (read == toldHash_ || !mayTell(now))) {
    reply.truncate(flagsAt);
    return false;
  }
  for (uint16_t left = percepts.leftOut(); left != 0; left--) counters_->count(Counter::PERCEPTS_LEFT_OUT);
  deadBands_.told();
  told_ = true;
  toldAt_ = now;
  toldHash_ = read;
  return true;
}

}  // namespace javinolib
