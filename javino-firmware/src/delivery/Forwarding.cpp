#include "Forwarding.h"

#include <string.h>

#include "../support/Clock.h"
#include "../support/Crc16.h"

namespace javinolib {

namespace {

const uint8_t FROM_SENDER = 1;  // hops of a copy of what its sender itself has sent

// In slots (SPEC 7.5).
const uint8_t NEW_SLOTS = 8;
const uint8_t DOUBTFUL_SLOTS = 30;  // in which an answer would have come
const uint8_t AGAIN_SLOTS = 6;
const uint8_t REPEAT_SLOTS = 2;
const uint8_t ANSWER_SLOTS = 1;
const uint8_t TO_MANY_SLOTS = 1;  // before its sender goes on
const uint8_t REPEAT_WAIT = 20;
const uint8_t ANSWER_REPEAT_WAIT = 14;
const uint8_t TURN = 45;  // the time of a packet and of its acknowledgement
const uint8_t SOON = 24;
const uint8_t RESERVE_QUIET = 18;
const uint8_t SPREAD_MASK = 7;
const uint8_t NEW_SPREAD_MASK = 15;
const uint8_t DOUBTFUL_SPREAD_MASK = 127;
const uint8_t ANSWER_SPREAD_MASK = 3;

const uint16_t LATE_MILLIS = 1500;
const uint8_t LATE_PACKETS = 3;  // on a slow channel: their time on the air
const uint16_t ANSWER_AGAIN_MILLIS = 200;
const uint8_t MOST_ANSWERS = 4;
const uint8_t ANSWER_REPEATS = 2;

uint8_t oneMore(uint8_t hops) { return static_cast<uint8_t>((hops + 1) % HOPS_MODULUS); }

// The parts of a path (SPEC 6): the hops behind a packet, and one more than the distance that it tells, 0 where it tells none.
uint8_t hopsIn(uint8_t path) { return static_cast<uint8_t>(path % HOPS_MODULUS); }
uint8_t distanceIn(uint8_t path) { return static_cast<uint8_t>(path / HOPS_MODULUS); }
uint8_t pathOf(uint8_t hops, uint8_t distance) { return static_cast<uint8_t>(hops + HOPS_MODULUS * distance); }

}  // namespace

void Forwarding::tell(trace::Point point, const Entry &entry, uint8_t second) {
  trace::tell(point, static_cast<uint8_t>(reinterpret_cast<uintptr_t>(&entry)), second);
}

void Forwarding::heard(const Frame &frame, const uint8_t *packet, uint8_t length, uint8_t path, bool isForUs) {
  if (!isOn()) return;
  memory_->distances.heard(Distances::numberOf(packet + Address::TEXT_LENGTH), hopsIn(path));
  if (isForUs) return;
  passTime();
  const Address::Kind to = frame.destination.kind();
  if (to == Address::ACKNOWLEDGEMENT) {
    answerHeard(frame, packet, length, path);
  } else if (to == Address::BROADCAST || to == Address::MULTICAST) {
    packetHeard(packet, length, path, true);
  } else if (to == Address::DEVICE && length >= HEAD_LENGTH) {
    packetHeard(packet, length, path, false);
  }
}

// The side from which a packet comes, beside a copy of ours.
Forwarding::Place Forwarding::placeOf(uint8_t hops, uint8_t own) {
  if (hops == own) return PEER;
  return oneMore(hops) == own ? UPSTREAM : DOWNSTREAM;
}

Forwarding::Entry *Forwarding::find(const uint8_t *packet, uint8_t length, uint16_t crc) {
  for (Entry &entry : memory_->entries) {
    const uint8_t kept = entry.answered ? HEAD_LENGTH : length;
    if (entry.length == length && entry.crc == crc && memcmp(entry.bytes, packet, kept) == 0) return &entry;
  }
  return nullptr;
}

// Returns null where all have something to send.
Forwarding::Entry *Forwarding::place() {
  Entry *oldest = nullptr;
  for (Entry &entry : memory_->entries) {
    if (entry.length == 0) return &entry;
    if (entry.due != NOTHING || entry.sending) continue;
    if (!oldest || entry.age > oldest->age) oldest = &entry;
  }
  return oldest;
}

void Forwarding::packetHeard(const uint8_t *packet, uint8_t length, uint8_t path, bool toMany) {
  const uint8_t hops = hopsIn(path);
  Crc16 crc;
  crc.add(packet, length);
  Entry *entry = find(packet, length, crc.value());
  if ((entry && heardAgain(*entry, hops)) || (toMany && hops != 0)) return;
  const bool late = entry;
  if (entry) {
    entry->length = 0;
    tell(trace::RELAY_FORGET, *entry);
  }
  const uint16_t to = Distances::numberOf(packet);
  const bool trusted = !toMany && memory_->distances.scoreOf(to) == Distances::NONE;
  const uint16_t least = trusted || toMany ? costOf(length) : static_cast<uint16_t>(MOST / 2);
  entry = credits_[toMany] < least ? nullptr : place();
  if (!entry) {
    counters_->count(Counter::RELAY_REFUSED);
    return;
  }
  *entry = Entry();
  entry->length = length;
  entry->crc = crc.value();
  entry->to = to;
  entry->toMany = toMany;
  entry->late = late;
  memcpy(entry->bytes, packet, length);
  bool isAway = false;
  if (!late && !toMany) {
    entry->distance = memory_->distances.to(to);
    const uint8_t told = distanceIn(path);
    isAway = told != 0 && (entry->distance == 0 || oneMore(entry->distance) != hopsIn(told));
    tell(trace::RELAY_DISTANCE, *entry, entry->distance);
  }
  tell(trace::RELAY_NEW, *entry, entry->bytes[HEAD_LENGTH - 1]);
  begin(*entry, hops, false, isAway);
}

void Forwarding::begin(Entry &entry, uint8_t hops, bool fromReserve, bool isAway) {
  const uint8_t score = entry.toMany ? Distances::FIRST : memory_->distances.scoreOf(entry.to);
  entry.hops = oneMore(hops);
  entry.trusted = score == Distances::NONE;
  entry.fromReserve = fromReserve;
  entry.reserve = !fromReserve && (isAway || score == Distances::MOST);
  entry.repeated = !entry.trusted || fromReserve;
  entry.handedOn = entry.prompt = entry.answered = entry.answerHandedOn = false;
  entry.answers = 0;
  entry.quiet = 0;
  entry.age = 0;
  if (entry.reserve) {
    tell(trace::RELAY_RESERVE, entry);
    return;
  }
  uint8_t first = DOUBTFUL_SLOTS;
  uint8_t mask = DOUBTFUL_SPREAD_MASK;
  if (entry.toMany) {
    first = TO_MANY_SLOTS;
    mask = SPREAD_MASK;
  } else if (entry.trusted || fromReserve || entry.distance != 0) {
    first = NEW_SLOTS;
    mask = NEW_SPREAD_MASK;
  }
  wait(entry, COPY, first, static_cast<uint8_t>(random_->next(mask) + (fromReserve ? TURN : 0)), trace::RELAY_DRAW);
}

// Returns false where the packet is to begin anew: what was its acknowledgement may have been forged.
bool Forwarding::heardAgain(Entry &entry, uint8_t hops) {
  if (!entry.answered) {
    copyHeard(entry, hops);
    return true;
  }
  const bool isIdle = entry.due == NOTHING && !entry.sending;
  const uint16_t again = entry.copied ? ANSWER_AGAIN_MILLIS : lateMillis(entry);
  if (!isIdle || placeOf(hops, entry.hops) == DOWNSTREAM || entry.age <= again) return true;
  if (entry.answers >= MOST_ANSWERS) return false;
  wait(entry, ANSWER, AGAIN_SLOTS, spread(true), trace::RELAY_DRAW_ANSWER_AGAIN);
  return true;
}

// After so long what comes again is no repetition that was on its way.
uint16_t Forwarding::lateMillis(const Entry &entry) const {
  const uint16_t repeated = static_cast<uint16_t>(LATE_PACKETS * medium_->airtimeMillis(entry.length));
  return repeated > LATE_MILLIS ? repeated : LATE_MILLIS;
}

// A relay that is in reserve as others are nearer may be needed when the packet comes so late.
bool Forwarding::isInReserveForScore(const Entry &entry) const {
  return entry.reserve && memory_->distances.scoreOf(entry.to) == Distances::MOST;
}

void Forwarding::copyHeard(Entry &entry, uint8_t hops) {
  const Place from = placeOf(hops, entry.hops);
  const bool isIdle = entry.due == NOTHING && !entry.sending;
  const bool isLate =
      entry.toMany ? hops == 0 && entry.age > medium_->mostCopyMillis() / 2 : entry.age > lateMillis(entry);
  if (isIdle && isLate && !isInReserveForScore(entry) && (!entry.copied || from == UPSTREAM)) {
    entry.late = true;
    entry.distance = 0;
    tell(trace::RELAY_ANEW, entry);
    begin(entry, hops, false);
  } else if (from == DOWNSTREAM) {
    if (entry.copied && entry.quiet < SOON) entry.prompt = true;
    entry.handedOn = true;
    tell(trace::RELAY_GONE_ON, entry, entry.prompt);
    entry.due = NOTHING;
    entry.age = 0;
  } else if (from == PEER) {
    if (entry.copied || entry.due == NOTHING) return;
    tell(trace::RELAY_PEER, entry);
    entry.due = NOTHING;
    entry.age = 0;
  } else if (entry.reserve) {
    if (entry.quiet >= RESERVE_QUIET) {
      tell(trace::RELAY_STEP_IN, entry);
      begin(entry, hops, true);
    } else {
      tell(trace::RELAY_RESERVE, entry);
    }
    entry.quiet = 0;
  } else if (hops == 0 && entry.hops == FROM_SENDER && !entry.toMany && !entry.sending &&
             (entry.copied || entry.due == NOTHING)) {
    wait(entry, COPY, AGAIN_SLOTS, spread(!entry.handedOn), trace::RELAY_DRAW_AGAIN);
  }
}

void Forwarding::answerHeard(const Frame &frame, const uint8_t *packet, uint8_t length, uint8_t path) {
  const uint8_t told = distanceIn(path);
  if (frame.length != PROOF_LENGTH && length != MAX_ANSWER) return;
  for (Entry &entry : memory_->entries) {
    if (entry.length == 0) continue;
    Frame kept;
    Frame::parseHeader(entry.bytes, kept);
    const uint8_t *nonceEnd = entry.bytes + HEAD_LENGTH - 2;
    const uint16_t bits = static_cast<uint16_t>((nonceEnd[0] << 8 | nonceEnd[1]) & 0xFFF);
    if (kept.destination != frame.origin || frame.destination.member() != bits) continue;
    if (!entry.answered) {
      firstAnswer(entry, packet, length, path);
    } else if (told != 0) {
      const Place from = placeOf(hopsIn(told - 1), entry.hops);
      if (from == UPSTREAM) entry.answerHandedOn = true;
      if (from != DOWNSTREAM) {
        entry.due = NOTHING;
        tell(from == PEER ? trace::RELAY_ANSWER_PEER : trace::RELAY_ANSWER_GONE_ON, entry);
      }
    }
    entry.age = 0;
  }
}

void Forwarding::firstAnswer(Entry &entry, const uint8_t *packet, uint8_t length, uint8_t path) {
  const uint8_t score = memory_->distances.scoreOf(entry.to);
  const uint8_t told = distanceIn(path);
  const bool direct = told == 0;
  entry.due = NOTHING;
  entry.reserve = false;
  entry.answered = true;
  entry.answerHops = oneMore(hopsIn(path));
  entry.answerLength = length;
  memcpy(entry.bytes + HEAD_LENGTH, packet, length);
  add(credits_[0], entry.spent);
  entry.spent = 0;
  if (direct && entry.copied && entry.quiet < SOON) entry.prompt = true;
  if (!entry.copied) {
    memory_->distances.setScore(entry.to, static_cast<uint8_t>(score == Distances::MOST ? score : score + 1));
  } else if (entry.prompt) {
    memory_->distances.setScore(entry.to, entry.fromReserve ? Distances::AFTER_RESERVE : Distances::NONE);
  } else if (direct) {
    memory_->distances.setScore(entry.to, Distances::MOST);
  }
  tell(trace::RELAY_ANSWERED, entry, memory_->distances.scoreOf(entry.to));
  if (entry.copied && (direct ? entry.prompt : placeOf(hopsIn(told - 1), entry.hops) == DOWNSTREAM)) {
    wait(entry, ANSWER, ANSWER_SLOTS, static_cast<uint8_t>(random_->next(ANSWER_SPREAD_MASK)),
         trace::RELAY_DRAW_ANSWER);
  }
}

void Forwarding::wait(Entry &entry, Due due, uint8_t first, uint8_t left, trace::Point point) {
  entry.due = due;
  entry.first = first;
  entry.left = left;
  tell(point, entry, left);
}

// A random number of slots, and perhaps a turn of another relay, which may not be heard.
uint8_t Forwarding::spread(bool turn) {
  const uint8_t slots = static_cast<uint8_t>(random_->next(SPREAD_MASK));
  return static_cast<uint8_t>(turn && random_->next(1) != 0 ? slots + TURN : slots);
}

// Counts the time and the quiet slots that have passed.
void Forwarding::passTime() {
  const uint16_t now = static_cast<uint16_t>(clock::millis());
  const uint16_t passed = static_cast<uint16_t>(now - lookedAt_);
  lookedAt_ = now;
  for (uint16_t &credit : credits_) add(credit, passed);
  for (Entry &entry : memory_->entries) add(entry.age, passed);
  const uint8_t slots = medium_->quietSlots();
  if (slots < slots_ && slots < MediumAccess::CIRCLE) slots_ = 0;
  for (; slots_ != slots; slots_ = MediumAccess::slotAfter(slots_)) {
    for (Entry &entry : memory_->entries) {
      if (entry.quiet != UINT8_MAX) entry.quiet++;
      if (slots_ >= entry.first && entry.left != 0) entry.left--;
    }
  }
}

// More than there can ever be where a packet takes so long.
uint16_t Forwarding::costOf(uint8_t length) const {
  const uint16_t millis = medium_->airtimeMillis(length);
  return millis > MOST / TENTHS ? UINT16_MAX : static_cast<uint16_t>(millis * TENTHS);
}

void Forwarding::add(uint16_t &sum, uint16_t more) {
  sum = more > MOST - sum ? MOST : static_cast<uint16_t>(sum + more);
}

void Forwarding::run() {
  if (!isOn()) return;
  passTime();
  for (Entry &entry : memory_->entries) {
    if (entry.length == 0) continue;
    const uint8_t slots = medium_->quietSlots();
    if (entry.sending && !medium_->isSending()) sent(entry);
    if (entry.due != NOTHING && slots >= entry.first && entry.left == 0) send(entry);
  }
}

void Forwarding::send(Entry &entry) {
  if (entry.due == ANSWER) {
    const uint8_t path = pathOf(entry.answerHops, static_cast<uint8_t>(entry.hops + 1));
    if (!medium_->sendCopy(entry.bytes + HEAD_LENGTH, entry.answerLength, path)) return;
    entry.answers++;
    tell(trace::RELAY_ANSWER, entry, path);
    counters_->count(Counter::RELAY_ANSWERS);
  } else {
    const uint16_t cost = costOf(entry.length);
    uint16_t &credit = credits_[entry.toMany];
    if (credit < cost || (entry.toMany && entry.age > medium_->mostCopyMillis())) {
      entry.due = NOTHING;
      tell(trace::RELAY_REFUSE, entry);
      counters_->count(Counter::RELAY_REFUSED);
      return;
    }
    const uint8_t path = pathOf(entry.hops, entry.distance);
    if (!medium_->sendCopy(entry.bytes, entry.length, path)) return;
    credit = static_cast<uint16_t>(credit - cost);
    add(entry.spent, cost);
    entry.copied = true;
    tell(trace::RELAY_COPY, entry, path);
    counters_->count(Counter::RELAY_COPIES);
  }
  entry.due = NOTHING;
  entry.sending = true;
}

// Our copy has ended.
void Forwarding::sent(Entry &entry) {
  entry.sending = false;
  entry.age = 0;
  tell(entry.answered ? trace::RELAY_ANSWER_ENDED : trace::RELAY_COPY_ENDED, entry);
  if (entry.answered) {
    if (entry.hops != FROM_SENDER && !entry.answerHandedOn && entry.answers <= ANSWER_REPEATS) {
      wait(entry, ANSWER, AGAIN_SLOTS, static_cast<uint8_t>(ANSWER_REPEAT_WAIT + spread(false)),
           trace::RELAY_DRAW_ANSWER_REPEAT);
    }
    return;
  }
  entry.quiet = 0;
  if (entry.repeated || entry.handedOn) return;
  entry.repeated = true;
  wait(entry, COPY, REPEAT_SLOTS, static_cast<uint8_t>(REPEAT_WAIT + spread(true)), trace::RELAY_DRAW_REPEAT);
}

}  // namespace javinolib
