#include "Poll.h"

#include <string.h>

#include "../support/Clock.h"

namespace javinolib {

namespace {

// Of a request.
const uint8_t PERCEPTS_WANTED = 1;
const uint8_t READING_NOW = 2;
const uint8_t REPLY_LOST = 4;
const uint8_t REPLY_COMING = 8;

// Of a reply.
const uint8_t MORE_WAITING = 1;
const uint8_t PERCEPTS_LEFT_OUT = 2;
const uint8_t HAS_READING = 4;
const uint8_t MEMORY_DAMAGED = 8;
const uint8_t FLAGS_AT = 1 + HEADER_LENGTH + 1;  // in its packet, behind the status

// Four bytes a step, the last ones perhaps twice. The chance that a reading has the hash of another one, and so is not told
// after it, is about 1 in four thousand million; the next change is told then. FNV-1a would take AVR five times as long.
uint32_t hash(const uint8_t *bytes, uint16_t length) {
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

void Poll::tellAgain() {
  outcomes_.keepTold();
  inbox_.noKeys().keepTold();
  overheard_.keepTold();
  told_ = false;
}

bool Poll::hold(uint8_t flags, uint16_t holdMillis, uint32_t leastMillis) {
  const uint8_t percepts = flags & (PERCEPTS_WANTED | READING_NOW);
  if (flags > (PERCEPTS_WANTED | READING_NOW | REPLY_LOST | REPLY_COMING) || percepts == READING_NOW) return false;
  if ((flags & REPLY_LOST) != 0) {
    tellAgain();
  } else if ((flags & REPLY_COMING) == 0) {
    outcomes_.forgetTold();
    inbox_.noKeys().forgetTold();
    overheard_.forgetTold();
  }
  flags_ = flags;
  leastMillis_ = leastMillis;
  endsAt_ = clock::millis() + holdMillis;
  held_ = true;
  if (percepts == 0) told_ = false;
  return true;
}

bool Poll::answer(Reply &reply, bool released) {
  if (!held_) return true;
  const uint32_t now = clock::millis();
  if (isWaiting()) {
    addWaiting(reply);
  } else if (!isReadingDue(now, released) || !addReading(now, reply)) {
    if (!released && !isOver(now)) return false;
    reply.add(0);
  }
  if (config::STATISTICS && counters_.value(Counter::MEMORY_DAMAGED) != 0) reply.packet()[FLAGS_AT] |= MEMORY_DAMAGED;
  held_ = false;
  return true;
}

bool Poll::isWaiting() const {
  return outcomes_.areUntold() || inbox_.first().bytes != nullptr || inbox_.noKeys().areUntold() ||
         overheard_.areUntold();
}

void Poll::addWaiting(Reply &reply) {
  const uint16_t flagsAt = reply.mark();
  reply.add(0);
  addOutcomes(reply);
  if (!addMessages(reply) || !addNoKeys(reply) || !addOverheard(reply)) reply.replace(flagsAt, MORE_WAITING);
}

// All of them fit: Outcomes::MAX_UNREPORTED sees to that.
void Poll::addOutcomes(Reply &reply) {
  while (outcomes_.areUntold()) {
    const TransmissionEnd &end = outcomes_.tell();
    Record record(reply, 'T');
    record.add(end.number);
    record.add(static_cast<uint8_t>(end.outcome));
    record.close();
  }
}

// Returns whether all messages fitted.
bool Poll::addMessages(Reply &reply) {
  uint8_t number = inbox_.firstNumber();
  for (ByteQueue::Record record = inbox_.first(); record.bytes != nullptr; record = inbox_.after(record)) {
    if (!addMessage(number++, Inbox::read(record), reply)) return false;
  }
  return true;
}

// Returns whether all fitted.
bool Poll::addNoKeys(Reply &reply) {
  while (inbox_.noKeys().areUntold()) {
    const KeylessFrame &frame = inbox_.noKeys().next();
    uint8_t addresses[2 * Address::TEXT_LENGTH];
    frame.destination.write(addresses);
    frame.origin.write(addresses + Address::TEXT_LENGTH);
    Record record(reply, 'N');
    record.add(addresses, sizeof addresses);
    if (!record.close()) return false;
    inbox_.noKeys().tell();
  }
  return true;
}

// Returns whether all packets fitted.
bool Poll::addOverheard(Reply &reply) {
  for (ByteQueue::Record packet = overheard_.firstUntold(); packet.bytes != nullptr;
       packet = overheard_.after(packet)) {
    Record record(reply, 'O');
    record.add(packet.bytes, packet.length);
    if (!record.close()) return false;
    overheard_.tell();
  }
  return true;
}

bool Poll::addMessage(uint8_t number, const Inbox::Message &message, Reply &reply) {
  const uint8_t id[] = {message.nonce[2], message.nonce[4], message.nonce[5]};
  Record record(reply, 'M');
  record.add(number);
  record.add(message.addresses, 2 * Address::TEXT_LENGTH);
  record.add(id, sizeof id);
  record.add(message.content, message.length);
  return record.close();
}

// Sensors are not read for a poll that is to make room for another request, which may be an action: that must not wait.
bool Poll::isReadingDue(uint32_t now, bool released) const {
  if ((flags_ & PERCEPTS_WANTED) == 0) return false;
  if ((flags_ & READING_NOW) != 0) return true;
  if (released) return false;
  if (!told_) return true;
  return now - toldAt_ >= leastMillis_ && (isOver(now) || now - sampledAt_ >= sampleMillis_);
}

// Returns whether the reading is to be told; where not, the reply is as before.
bool Poll::addReading(uint32_t now, Reply &reply) {
  const uint16_t flagsAt = reply.mark();
  reply.add(HAS_READING);
  const bool anew = !told_ || (flags_ & READING_NOW) != 0;
  deadBands_.begin(anew);
  Percepts percepts(reply, deadBands_);
  if (source_ != nullptr) source_(percepts);
  if (percepts.leftOut() != 0) reply.replace(flagsAt, HAS_READING | PERCEPTS_LEFT_OUT);
  const uint32_t read = hash(reply.packet() + flagsAt, static_cast<uint16_t>(reply.mark() - flagsAt));
  sampledAt_ = now;
  if (!anew && read == toldHash_) {
    reply.truncate(flagsAt);
    return false;
  }
  for (uint16_t left = percepts.leftOut(); left != 0; left--) counters_.count(Counter::PERCEPTS_LEFT_OUT);
  told_ = true;
  toldAt_ = now;
  toldHash_ = read;
  return true;
}

}  // namespace javinolib
