#include "Courier.h"

#include <string.h>

#include "../Config.h"
#include "../support/Clock.h"
#include "Pieces.h"

namespace javino {

static const uint8_t MAX_ATTEMPTS = 8;
static const uint8_t PATIENCE_MILLIS = 150;
static const uint8_t IDS = 64;

void Courier::run() {
  backoff_.listen(medium_.quietSlots());
  if (phase_ == IDLE && !outbox_.isEmpty()) takeUpNext();
  switch (phase_) {
    case IDLE: break;
    case CONTENDING:
      noteCarrier();
      if (backoff_.isOver(medium_.quietSlots())) send();
      break;
    case PAUSING:
      noteCarrier();
      if (medium_.quietSlots() != 0) send();
      break;
    case ON_AIR:
      if (!medium_.isSending()) packetSent();
      break;
    case AWAITING:
      patience_ = static_cast<uint8_t>(patience_ > medium_.quietMillis() ? patience_ - medium_.quietMillis() : 0);
      if (patience_ == 0) attemptFailed();
      break;
  }
}

// Takes up the next message. What can no longer be sealed ends at once: its key was deleted meanwhile, or no nonce is left.
void Courier::takeUpNext() {
  Frame frame;
  Frame::parseHeader(outbox_.first().bytes, frame);
  destination_ = frame.destination;
  sender_ = frame.origin;
  slot_ = KeyStore::NO_SLOT;
  resealed_ = false;
  sendsLeft_ = destination_.isMulticast() ? config::MULTICAST_SENDS : config::BROADCAST_SENDS;
  if (destination_.isBroadcast() || seal(false)) {
    restart();
  } else {
    finish(Outcome::UNDELIVERED);
  }
}

// Seals the frame in its place in the outbox, under a new nonce.
bool Courier::seal(bool again) {
  DerivedKeys keys;
  if (!again) slot_ = state_.keys.current(destination_);
  if (!state_.keys.load(slot_, keys) || state_.nonces.status() != Status::OK) return false;
  const ByteQueue::Record record = outbox_.first();
  const Envelope envelope(keys);
  if (again) envelope.open(record.bytes, record.length);
  state_.nonces.take(nonce_);
  const Frame plain = {destination_, sender_, record.bytes + Envelope::CONTENT_AT,
                       static_cast<uint16_t>(record.length - Envelope::MIN_FRAME_LENGTH)};
  envelope.seal(plain, nonce_, record.bytes);
  return true;
}

// Begins the first attempt of a frame that nobody has seen yet.
void Courier::restart() {
  count_ = pieces::count(outbox_.first().length, medium_.pieceLength());
  if (count_ > 1) {
    id_ = nextId_;
    nextId_ = static_cast<uint8_t>((nextId_ + 1) % IDS);
  }
  sent_ = 0;
  arrived_ = 0;
  attempt_ = 0;
  contend(pieces::all(count_));
}

void Courier::contend(uint8_t pending) {
  pending_ = pending;
  backoff_.begin(attempt_, medium_.quietSlots(), state_.random);
  phase_ = CONTENDING;
}

// Counts each packet that waits for another's carrier to end, once.
void Courier::noteCarrier() {
  if (deferred_ || !medium_.hearsCarrier()) return;
  deferred_ = true;
  state_.count(Counter::RADIO_DEFERRED);
}

void Courier::send() {
  const ByteQueue::Record record = outbox_.first();
  uint8_t index = 0;
  for (onAir_ = 1; (pending_ & onAir_) == 0; onAir_ = static_cast<uint8_t>(onAir_ << 1)) index++;
  const bool wantsAnswer = isUnicast() && pending_ == onAir_;
  uint8_t piece[MAX_RADIO_PAYLOAD];
  const uint8_t digit = static_cast<uint8_t>(wantsAnswer ? index | pieces::WANTS_ANSWER : index);
  const bool taken =
      count_ == 1
          ? medium_.send(record.bytes, static_cast<uint8_t>(record.length))
          : medium_.send(piece, pieces::cut(record.bytes, record.length, id_, digit, medium_.pieceLength(), piece));
  if (!taken) return;
  if (sent_ == 0) sentAt_ = clock::millis();
  if ((sent_ & onAir_) != 0) state_.count(Counter::RADIO_RESENT);
  sent_ |= onAir_;
  deferred_ = false;
  phase_ = ON_AIR;
}

void Courier::packetSent() {
  pending_ = static_cast<uint8_t>(pending_ & ~onAir_);
  if (pending_ != 0) {
    phase_ = PAUSING;
  } else if (isUnicast()) {
    patience_ = PATIENCE_MILLIS;
    phase_ = AWAITING;
  } else if (--sendsLeft_ != 0) {
    attempt_++;
    contend(pieces::all(count_));
  } else {
    finish(Outcome::SENT);
  }
}

// No answer came: of a frame in pieces one asks what has arrived, in the end the first one, without which none can be
// answered; where that was there, the one that has just asked, every other time, as it is likely what is lacking.
void Courier::attemptFailed() {
  attempt_++;
  if (attempt_ == MAX_ATTEMPTS) {
    finish(Outcome::UNDELIVERED);
  } else {
    contend((arrived_ & attempt_ & 1) != 0 ? onAir_ : 1);
  }
}

void Courier::finish(Outcome outcome) {
  if (outcome != Outcome::SENT) slot_ = KeyStore::NO_SLOT;
  if (isUnicast()) {
    state_.count(outcome == Outcome::DELIVERED ? Counter::RADIO_ACKNOWLEDGED : Counter::RADIO_UNDELIVERED);
  }
  outbox_.close(outcome);
  deferred_ = false;
  phase_ = IDLE;
}

void Courier::keysChanged() {
  if (slot_ != KeyStore::NO_SLOT && state_.keys.isFree(slot_)) slot_ = KeyStore::NO_SLOT;
}

bool Courier::acknowledged(const Frame &frame) {
  if (!concerns(frame)) return false;
  const uint16_t bodyLength = static_cast<uint16_t>(frame.length - PROOF_LENGTH);
  const Proof::Claim claim = {bodyLength == 0   ? Proof::DELIVERED
                              : bodyLength == 1 ? Proof::PIECES
                                                : Proof::STALE,
                              nonce_, sender_, frame.origin, frame.message};
  const bool right = frame.length >= PROOF_LENGTH && bodyLength == Proof::bodyLength(claim.type) &&
                     isProved(claim, frame.message + bodyLength) && onAnswer(claim.type, claim.body);
  if (!right) state_.count(Counter::RADIO_BAD_PROOFS);
  return true;
}

// Apart from what follows, which may seal the message anew: the stack has no room for the keys of both.
bool Courier::isProved(const Proof::Claim &claim, const uint8_t *proof) const {
  DerivedKeys keys;
  return state_.keys.load(slot_, keys) && Proof(keys).isRight(claim, proof);
}

bool Courier::concerns(const Frame &acknowledgement) const {
  const uint16_t bits = static_cast<uint16_t>((nonce_[4] << 8 | nonce_[5]) & 0xFFF);
  return slot_ != KeyStore::NO_SLOT && acknowledgement.destination.member() == bits &&
         (!isUnicast() || acknowledgement.origin == destination_);
}

// Returns false where what was said, though proved, cannot be.
bool Courier::onAnswer(Proof::Type type, const uint8_t *body) {
  switch (type) {
    case Proof::DELIVERED:
      if (isUnicast()) finish(Outcome::DELIVERED);
      return isUnicast();
    case Proof::PIECES: return onPieces(body[0]);
    case Proof::STALE: return onStale(body, static_cast<uint16_t>(body[NONCE_LENGTH] << 8 | body[NONCE_LENGTH + 1]));
  }
  return false;
}

// Sends what is lacking, as soon as pieces follow each other: whoever heard the answer or the question leaves the air to
// them. While a new attempt is already on the air, its own answer is waited for.
bool Courier::onPieces(uint8_t have) {
  const uint8_t all = pieces::all(count_);
  if (!isUnicast() || count_ == 1 || (have & 1) == 0 || (have & ~all) != 0) return false;
  const bool isNews = (have & ~arrived_) != 0;
  arrived_ |= have;
  if (have == all || (phase_ != AWAITING && phase_ != CONTENDING)) return true;
  if (isNews) {
    attempt_ = 0;
  } else if (phase_ == AWAITING && ++attempt_ == MAX_ATTEMPTS) {
    finish(Outcome::UNDELIVERED);
    return true;
  }
  pending_ = static_cast<uint8_t>(all & ~have);
  phase_ = PAUSING;
  return true;
}

bool Courier::onStale(const uint8_t *floor, uint16_t uptime) {
  if (!state_.nonces.raiseAbove(floor, nonce_)) return false;
  if (!isUnicast()) return true;
  if (!resealed_ && cannotHaveHadIt(uptime) && seal(true)) {
    resealed_ = true;
    restart();
  } else {
    finish(Outcome::UNDELIVERED);
  }
  return true;
}

// Whether the receiver has been up for longer than this message is on its way, so that it did not have it before it lost
// its memory: by a sixteenth and 1 s more, since clocks differ.
bool Courier::cannotHaveHadIt(uint16_t uptime) const {
  const uint32_t onItsWay = clock::millis() - sentAt_;
  return uptime * 100ul > onItsWay + onItsWay / 16 + 1000;
}

}  // namespace javino
