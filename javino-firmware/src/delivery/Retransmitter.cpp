#include "Retransmitter.h"

#include <string.h>

#include "../Config.h"
#include "../crypto/Cmac.h"
#include "../support/Clock.h"
#include "Fragments.h"

namespace javinolib {

static const uint8_t IDS = 64;

// In a packet's symbols, of which each byte takes two; the first two are the count.
static const uint8_t HEADER_AT = 2;
static const uint8_t BODY_AT = HEADER_AT + 2 * HEADER_LENGTH;

// A damaged acknowledgement is taken where no more of its bits are wrong. Of the 96 of a proof so many let a forger's guess
// succeed with 2^-44 (SECURITY.md), and only so many wrong guesses are looked at.
static const uint8_t MOST_WRONG_PROOF_BITS = 7;
static const uint8_t MOST_WRONG_HEADER_BITS = 15;
static const uint8_t MOST_WRONG_FRAGMENTS_BITS = 2;
static const uint8_t MOST_FRAGMENTS_GUESSED = 4;
static const uint8_t MOST_GUESSES = 16;

bool Retransmitter::isUnderWay(uint8_t slot) const {
  for (const Message &message : messages_) {
    if (message.slot == slot && message.phase != IDLE) return true;
  }
  return false;
}

template <typename Scope>
void Retransmitter::run() {
  backoff_.listen(medium_->quietSlots());
  if (current().phase <= READY && outbox_.count() != 0) nextTurn<Scope>();
  switch (current().phase) {
    case IDLE:
    case READY: break;
    case CONTENDING:
      if (config::PARTNERS > 1 && current().retries.attempts() != 0 && isUnicast<Scope>() && passes<Scope>()) break;
      acknowledger_->noteCarrier(deferred_);
      if (backoff_.isOver(medium_->quietSlots())) send<Scope>();
      break;
    case PAUSING:
      acknowledger_->noteCarrier(deferred_);
      if (medium_->quietSlots() != 0) send<Scope>();
      break;
    case ON_AIR:
      if (!medium_->isSending()) packetSent<Scope>();
      break;
    case AWAITING:
      if (patience_.isOver(medium_->quietMillis())) attemptFailed<Scope>();
      break;
  }
}

// Takes up a new message before those that wait or contend for a further attempt, unless one has let many pass. It takes the
// place of a multicast only where no other is free.
template <typename Scope>
bool Retransmitter::passes() {
  uint8_t free = config::PARTNERS;
  uint8_t underWay = 0;
  for (uint8_t place = 0; place < config::PARTNERS; place++) {
    const Message &message = messages_[place];
    if (message.phase != IDLE) {
      if (message.retries.isFirst()) return false;
      underWay++;
    } else if (free == config::PARTNERS ||
               (messages_[free].slot != KeyStore::NO_SLOT && message.slot == KeyStore::NO_SLOT)) {
      free = place;
    }
  }
  if (free == config::PARTNERS || underWay == outbox_.count()) return false;
  lookAt(messages_[free]);
  if (!takeUp<Scope>()) {
    lookAt(messages_[turn_]);
    return false;
  }
  turn_ = free;
  for (Message &message : messages_) {
    if (&message == &current() || message.phase == IDLE) continue;
    if (message.phase == CONTENDING) {
      trace::tell(trace::TURN, message.number);
      trace::tell(trace::PASSED);
    }
    message.phase = READY;
    message.retries.letPass();
  }
  contend();
  return true;
}

// Gives each place its turn, one after the other: to go on with its message, or to take one up.
template <typename Scope>
void Retransmitter::nextTurn() {
  if (config::PARTNERS > 1 && passes<Scope>()) return;
  for (uint8_t left = config::PARTNERS; left != 0; left--) {
    if (config::PARTNERS > 1) {
      turn_ = static_cast<uint8_t>((turn_ + 1) % config::PARTNERS);
      lookAt(messages_[turn_]);
    }
    if (mayContend<Scope>() || takeUp<Scope>()) {
      contend();
      return;
    }
  }
}

// Whether the message waits for its turn. One that was refused is sealed anew only here: where that is said, the stack has no room.
template <typename Scope>
bool Retransmitter::mayContend() {
  Message &message = current();
  if (message.phase != READY || !message.refused) return message.phase == READY;
  message.refused = false;
  return begin<Scope>(true);
}

// Seals the frame, unless it is a broadcast's; if that cannot be, its message has ended.
template <typename Scope>
bool Retransmitter::begin(bool again) {
  Message &message = current();
  if ((!Scope::MANY || !message.destination.isBroadcast()) && !seal(again)) {
    finish<Scope>(Outcome::UNDELIVERED);
    return false;
  }
  restart();
  tell(static_cast<trace::Point>(trace::TAKE_UP + again), message.slot);
  return true;
}

// Takes up a message of the outbox (SPEC 7.2, rules 2 and 3):
// 1. None of a device that has one under way.
// 2. The last free place is for a device that acknowledged its last message, or for many.
// 3. The oldest one to a device that was not the last in any place; if there is none, the oldest of all others: a device that
//    was may be absent.
// A message that can no longer be sealed ends at once: its key was deleted meanwhile, or no nonce is left.
template <typename Scope>
bool Retransmitter::takeUp() {
  Message &message = current();
  ByteQueue::Record taken = {nullptr, 0};
  Turn best = AFTER_ITS_LAST;
  for (ByteQueue::Record record = outbox_.first(); record.bytes != nullptr && best != FIRST;
       record = outbox_.after(record)) {
    Address destination;
    Address::parse(record.bytes, destination);
    const Turn turn = turnOf(destination);
    if (turn <= best) continue;
    best = turn;
    taken = record;
  }
  if (best == AFTER_ITS_LAST) return false;
  message.number = Outbox::numberOf(taken);
  trace::tell(trace::TURN, message.number);
  Address::parse(taken.bytes, message.destination);
  Address::parse(taken.bytes + Address::TEXT_LENGTH, message.sender);
  message.slot = KeyStore::NO_SLOT;
  message.refused = false;
  message.resealed = false;
  if (config::PARTNERS > 1) message.retries.begin();
  return begin<Scope>(false);
}

// The turn of a message to this destination, if it is the oldest one. A message to many keeps its turn until it has ended, so
// none of them is under way here.
Retransmitter::Turn Retransmitter::turnOf(const Address &destination) const {
  Turn turn = FIRST;
  if (config::PARTNERS == 1 || !destination.isDevice()) return turn;
  uint8_t free = 0;
  for (const Message &message : messages_) {
    if (message.phase == IDLE) free++;
    if (message.destination != destination) continue;
    if (message.phase != IDLE) return AFTER_ITS_LAST;
    turn = AFTER_OTHERS;
  }
  return free == 1 && !partners_.has(state_->keys.current(destination), ANSWERS) ? AFTER_ITS_LAST : turn;
}

// Seals the frame in its place in the outbox, under a new nonce.
bool Retransmitter::seal(bool again) {
  Message &message = current();
  DerivedKeys keys;
  if (!again) message.slot = state_->keys.current(message.destination);
  if (!state_->keys.load(message.slot, keys) || state_->nonces.status() != Status::OK) return false;
  const ByteQueue::Record record = outbox_.find(message.number);
  const Envelope envelope(keys);
  if (again) envelope.open(record.bytes, record.length);
  state_->nonces.take(message.nonce);
  state_->keys.used(message.slot);
  envelope.seal(record.bytes, record.length, message.nonce);
  return true;
}

// As it is to be on the air. One that is relayed waits in the outbox as the message of a broadcast from the serial line.
ByteQueue::Record Retransmitter::frame() const {
  const Message &message = current();
  ByteQueue::Record record = outbox_.find(message.number);
  if (config::LARGE && message.sender.isSerial()) {
    record.bytes += HEADER_LENGTH;
    record.length = static_cast<Length>(record.length - HEADER_LENGTH);
  }
  return record;
}

// Prepares the first attempt of a frame that nobody has seen yet.
void Retransmitter::restart() {
  Message &message = current();
  message.count = fragments::count(frame().length, medium_->fragmentLength());
  if (message.count > 1) {
    message.id = nextId_;
    nextId_ = static_cast<uint8_t>(static_cast<uint8_t>(nextId_ + 1) % IDS);
  }
  message.sent = 0;
  message.arrived = 0;
  message.retries.restart();
  message.guesses = 0;
  message.trailed = false;
  message.pending = fragments::all(message.count);
}

void Retransmitter::contend() {
  backoff_.begin(current().retries.attempts(), medium_->quietSlots(), state_->random);
  current().phase = CONTENDING;
  deferred_ = false;
  tell(trace::CONTEND, backoff_.left());
}

// Parity follows where the partner has asked for it; a packet that is sent again, if the partner is known to understand it. To
// others such a packet tells that we do.
template <typename Scope>
Trailer Retransmitter::trailer() const {
  const Message &message = current();
  if (!config::LARGE || !isUnicast<Scope>()) return Trailer::NONE;
  const bool again = (message.sent & onAir_) != 0;
  if (partners_.has(message.slot, ASKS_PARITY) || (again && partners_.has(message.slot, KNOWS_PARITY))) {
    return Trailer::PARITY;
  }
  return again ? Trailer::MARK : Trailer::NONE;
}

void Retransmitter::noteParity(const Proof::Claim &claim) {
  if (!config::LARGE || claim.type == Proof::STALE) return;
  partners_.set(current().slot, claim.asksParity, ASKS_PARITY);
  if (claim.asksParity) partners_.set(current().slot, true, KNOWS_PARITY);
}

inline bool Retransmitter::sendWhole(const ByteQueue::Record &record, Trailer trailer) {
  const uint8_t length = static_cast<uint8_t>(record.length);
#if JAVINO_LARGE
  if (distances_ && current().sent == 0) {
    const uint8_t distance = distances_->to(Distances::numberOf(record.bytes));
    return medium_->sendCopy(record.bytes, length, static_cast<uint8_t>(HOPS_MODULUS * distance), trailer);
  }
#endif
  return medium_->send(record.bytes, length, trailer);
}

template <typename Scope>
void Retransmitter::send() {
  Message &message = current();
  const ByteQueue::Record record = frame();
  uint8_t index = 0;
  uint8_t bit = 1;
  for (; (message.pending & bit) == 0; bit = static_cast<uint8_t>(bit << 1)) index++;
  onAir_ = bit;
  const bool wantsAnswer = message.pending == bit && isUnicast<Scope>();
  const Trailer trailer = this->trailer<Scope>();
  uint8_t fragment[MAX_RADIO_PAYLOAD];
  const uint8_t digit = static_cast<uint8_t>(wantsAnswer ? index | fragments::WANTS_ANSWER : index);
  const bool taken = message.count == 1 ? sendWhole(record, trailer)
                                        : medium_->send(fragment,
                                                        fragments::cut(record.bytes, record.length, message.id, digit,
                                                                       medium_->fragmentLength(), fragment),
                                                        trailer);
  if (!taken) return;
  message.trailed = message.trailed || trailer != Trailer::NONE;
  if (message.sent == 0) message.sentAt = clock::millis();
  if ((message.sent & bit) != 0) state_->count(Counter::RADIO_RESENT);
  message.sent |= bit;
  deferred_ = false;
  message.phase = ON_AIR;
  tell(trace::SEND, message.pending);
}

// A broadcast or multicast keeps its turn until it was sent as often as it is to be: receivers know a broadcast's repeat by
// the time between the two.
template <typename Scope>
void Retransmitter::packetSent() {
  Message &message = current();
  message.pending = static_cast<uint8_t>(message.pending & ~onAir_);
  if (message.pending != 0) {
    message.phase = PAUSING;
    tell(trace::PART_SENT);
  } else if (isUnicast<Scope>()) {
    await(message.retries.rounds(message.count == 1));
    tell(trace::AWAIT, patience_.rounds());
  } else if (!message.retries.sent(Scope::MANY && message.destination.isMulticast(), message.sender.isSerial())) {
    message.pending = fragments::all(message.count);
    contend();
  } else {
    finish<Scope>(Outcome::SENT);
  }
}

template <typename Scope>
void Retransmitter::attemptFailed() {
  Message &message = current();
  const bool isLast = message.retries.failed();
  tell(trace::ATTEMPT_FAILED, message.retries.attempts());
  if (isLast) {
    finish<Scope>(Outcome::UNDELIVERED);
  } else {
    message.pending = message.retries.next(message.arrived, onAir_);
    message.phase = READY;
    nextTurn<Scope>();
  }
}

template <typename Scope>
void Retransmitter::finish(Outcome outcome) {
  Message &message = current();
  partners_.set(message.slot, outcome == Outcome::DELIVERED, ANSWERS);
  if (outcome != Outcome::SENT) message.slot = KeyStore::NO_SLOT;
  if (isUnicast<Scope>()) {
    state_->count(outcome == Outcome::DELIVERED ? Counter::RADIO_ACKNOWLEDGED : Counter::RADIO_UNDELIVERED);
  }
  outbox_.close(message.number, outcome);
  message.phase = IDLE;
  tell(static_cast<trace::Point>(trace::SENT + static_cast<uint8_t>(outcome)));
}

template <typename Scope>
void Retransmitter::keysChanged() {
  for (Message &message : messages_) {
    lookAt(message);
    if (message.slot != KeyStore::NO_SLOT && state_->keys.isFree(message.slot)) {
      message.slot = KeyStore::NO_SLOT;
      if (message.phase != IDLE && isUnicast<Scope>()) finish<Scope>(Outcome::UNDELIVERED);
    }
  }
  lookAt(messages_[turn_]);
  for (uint8_t slot = 0; config::LARGE && slot < KeyStore::PLACES; slot++) {
    if (!state_->keys.isFree(slot)) continue;
    for (uint8_t flag = 0; flag < PARTNER_FLAGS; flag++) partners_.set(slot, false, flag);
  }
}

void Retransmitter::otherAcknowledged() {
  if (backoff_.otherAcknowledged(state_->random) && current().phase == CONTENDING)
    tell(trace::CONTEND, backoff_.left());
}

// An acknowledgement may be about a message whose turn has passed. Of two messages with the same bits in their nonces the proof
// tells which it is about.
template <typename Scope>
bool Retransmitter::acknowledged(const Frame &frame) {
  bool concerned = false;
  bool accepted = false;
  for (uint8_t place = 0; place < config::PARTNERS && !accepted; place++) {
    lookAt(messages_[place]);
    if (concerns<Scope>(frame)) {
      concerned = true;
      accepted = accept<Scope>(frame);
    }
  }
  lookAt(messages_[turn_]);
  if (concerned && !accepted) state_->count(Counter::RADIO_BAD_PROOFS);
  return concerned;
}

template <typename Scope>
bool Retransmitter::concerns(const Frame &acknowledgement) const {
  const Message &message = current();
  const uint16_t bits = static_cast<uint16_t>((message.nonce[4] << 8 | message.nonce[5]) & 0xFFF);
  return message.sent != 0 && message.slot != KeyStore::NO_SLOT && acknowledgement.destination.member() == bits &&
         (!isUnicast<Scope>() || acknowledgement.origin == message.destination);
}

template <typename Scope>
bool Retransmitter::accept(const Frame &acknowledgement) {
  const Length bodyLength = static_cast<Length>(acknowledgement.length - PROOF_LENGTH);
  Proof::Claim claim = {bodyLength == 0   ? Proof::DELIVERED
                        : bodyLength == 1 ? Proof::FRAGMENTS
                                          : Proof::STALE,
                        current().nonce,
                        current().sender,
                        acknowledgement.origin,
                        acknowledgement.message,
                        false};
  if (acknowledgement.length < PROOF_LENGTH || bodyLength != Proof::bodyLength(claim.type)) return false;
  while (!isProved(claim, acknowledgement.message + bodyLength)) {
    if (claim.asksParity) return false;
    claim.asksParity = true;
  }
  noteParity(claim);
  return onAnswer<Scope>(claim.type, claim.body);
}

template <typename Scope>
void Retransmitter::acknowledged(const RadioPacket &lost) {
  bool borne = false;
  for (uint8_t place = 0; place < config::PARTNERS && !borne; place++) {
    Message &message = messages_[place];
    lookAt(message);
    if (isUnicast<Scope>() && message.sent != 0 && message.slot != KeyStore::NO_SLOT) {
      borne =
          isExpected<Scope>(Proof::DELIVERED, lost) || (message.count > 1 && isExpected<Scope>(Proof::FRAGMENTS, lost));
    }
  }
  lookAt(messages_[turn_]);
  if (borne) state_->count(Counter::RADIO_ANSWERS_TOLERATED);
}

void Retransmitter::copied(const uint8_t *packet, uint8_t length) {
  Message &message = current();
  const bool contends = message.phase == CONTENDING && message.retries.attempts() != 0;
  if (!contends && message.phase != AWAITING) return;
  const ByteQueue::Record record = frame();
  if (length != record.length || memcmp(packet, record.bytes, Envelope::NONCE_AT + NONCE_LENGTH) != 0) return;
  if (contends) message.retries.carriedOn();
  await(Retries::ROUNDS_WITH_RELAY);
  tell(trace::COPIED);
}

void Retransmitter::await(uint8_t rounds) {
  patience_.begin(rounds);
  current().phase = AWAITING;
}

// Compares with the answers that the partner can give. All bits but those of the proof only show what it is about.
template <typename Scope>
bool Retransmitter::isExpected(Proof::Type type, const RadioPacket &lost) {
  Message &message = current();
  const uint8_t bodyLength = Proof::bodyLength(type);
  const uint8_t length = static_cast<uint8_t>(bodyLength + PROOF_LENGTH);
  const uint8_t count = lost.count();
  if (count != RadioPacket::NO_COUNT && count != HEADER_LENGTH + length + linecode::PACKET_OVERHEAD) return false;
  uint8_t header[HEADER_LENGTH];
  const uint16_t bits = static_cast<uint16_t>((message.nonce[4] << 8 | message.nonce[5]) & 0xFFF);
  Frame::writeHeader(header, Address::acknowledgement(bits), message.destination, length);
  if (lost.wrongBits(HEADER_AT, header, HEADER_LENGTH) > MOST_WRONG_HEADER_BITS) return false;
  if (message.guesses == MOST_GUESSES) return false;
  message.guesses++;
  const uint8_t last = bodyLength == 0 ? 0 : fragments::all(message.count);
  uint8_t have = bodyLength == 0 ? 0 : static_cast<uint8_t>(message.arrived | 1);
  for (uint8_t left = MOST_FRAGMENTS_GUESSED; left != 0; have++) {
    if (bodyLength == 0 || lost.wrongBits(BODY_AT, &have, 1) <= MOST_WRONG_FRAGMENTS_BITS) {
      left--;
      Proof::Claim claim = {type, message.nonce, message.sender, message.destination, &have, false};
      bool borne = isBorne(claim, lost);
      if (!borne && message.trailed) {
        claim.asksParity = true;
        borne = isBorne(claim, lost);
      }
      if (borne) {
        message.guesses--;  // it was none
        noteParity(claim);
        return onAnswer<Scope>(type, &have);
      }
    }
    if (have == last) break;
  }
  return false;
}

bool Retransmitter::isBorne(const Proof::Claim &claim, const RadioPacket &lost) const {
  uint8_t proof[PROOF_LENGTH];
  const uint8_t at = static_cast<uint8_t>(BODY_AT + 2 * Proof::bodyLength(claim.type));
  return acknowledger_->prove(current().slot, claim, proof) &&
         lost.wrongBits(at, proof, PROOF_LENGTH) <= MOST_WRONG_PROOF_BITS;
}

bool Retransmitter::isProved(const Proof::Claim &claim, const uint8_t *proof) const {
  uint8_t expected[PROOF_LENGTH];
  return acknowledger_->prove(current().slot, claim, expected) && equalInConstantTime(expected, proof, PROOF_LENGTH);
}

// Returns false where what was said, though proved, cannot be.
template <typename Scope>
bool Retransmitter::onAnswer(Proof::Type type, const uint8_t *body) {
  switch (type) {
    case Proof::DELIVERED:
      if (isUnicast<Scope>()) {
        if (config::LARGE) backoff_.acknowledged();
        finish<Scope>(Outcome::DELIVERED);
      }
      return isUnicast<Scope>();
    case Proof::FRAGMENTS: return onFragments<Scope>(body[0]);
    case Proof::STALE:
      return onStale<Scope>(body, static_cast<uint16_t>(body[NONCE_LENGTH] << 8 | body[NONCE_LENGTH + 1]));
  }
  return false;
}

// The receiver has told which fragments it has:
// 1. While an attempt is on the air, its own answer is awaited.
// 2. A message that waits for its turn goes on waiting, and then sends what is lacking.
// 3. Otherwise what is lacking follows after one quiet slot, without back-off: all who heard the answer leave the air to it.
template <typename Scope>
bool Retransmitter::onFragments(uint8_t have) {
  Message &message = current();
  const uint8_t all = fragments::all(message.count);
  if (!isUnicast<Scope>() || message.count == 1 || (have & 1) == 0 || (have & ~all) != 0) return false;
  const bool isNews = (have & ~message.arrived) != 0;
  message.arrived |= have;
  if (have == all || message.phase == PAUSING || message.phase == ON_AIR) return true;
  if (isNews) {
    message.retries.progressed();
    tell(trace::FRAGMENTS_NEW, have);
  } else {
    tell(trace::FRAGMENTS_KNOWN, have);
    if (message.phase == AWAITING && message.retries.failed()) {
      finish<Scope>(Outcome::UNDELIVERED);
      return true;
    }
  }
  message.pending = static_cast<uint8_t>(all & ~have);
  if (message.phase != READY) message.phase = PAUSING;
  return true;
}

template <typename Scope>
bool Retransmitter::onStale(const uint8_t *floor, uint16_t uptime) {
  Message &message = current();
  if (!state_->nonces.raiseAbove(floor, message.nonce)) return false;
  if (!isUnicast<Scope>() || message.refused) return true;
  tell(trace::STALE_HEARD);
  if (!message.resealed && cannotHaveHadIt(uptime)) {
    message.refused = true;
    message.resealed = true;
    message.phase = READY;
  } else {
    finish<Scope>(Outcome::UNDELIVERED);
  }
  return true;
}

// Whether the receiver has been up for longer than this message is on its way, so that it did not have it before it lost
// its memory: by a sixteenth and 1 s more, since clocks differ.
bool Retransmitter::cannotHaveHadIt(uint16_t uptime) const {
  const uint32_t onItsWay = clock::millis() - current().sentAt;
  return uptime * 100ul > onItsWay + onItsWay / 16 + 1000;
}

template void Retransmitter::run<WholeScope>();
template void Retransmitter::run<UnicastScope>();
template bool Retransmitter::acknowledged<WholeScope>(const Frame &);
template bool Retransmitter::acknowledged<UnicastScope>(const Frame &);
template void Retransmitter::acknowledged<WholeScope>(const RadioPacket &);
template void Retransmitter::acknowledged<UnicastScope>(const RadioPacket &);
template void Retransmitter::keysChanged<WholeScope>();
template void Retransmitter::keysChanged<UnicastScope>();

}  // namespace javinolib
