#include "Acknowledger.h"

#include <string.h>

#include "../framing/Frame.h"
#include "../support/Clock.h"
#include "../support/Trace.h"

namespace javinolib {

const uint8_t Acknowledger::CAPACITY;

static const uint8_t LEAST_PUT_OFF_SLOTS = 2;
static const uint16_t FURTHER_SLOTS_MASK = 3;
static const uint8_t MILLIS_A_UNIT = 100;  // of the uptime in a stale notice

void Acknowledger::add(Proof::Type type, uint8_t slot, const Address &sender, const uint8_t *nonce, uint8_t have) {
  Entry *entry = entries_;
  while (entry < end_) {
    if (entry->slot == slot && entry->sender == sender) {
      remove(entry);  // a sender awaits one answer at a time
    } else {
      entry++;
    }
  }
  if (entry == entries_ + CAPACITY) {
    state_->count(Counter::RADIO_ANSWERS_DROPPED);
    remove(entries_);
    entry--;
  }
  end_ = entry + 1;
  entry->type = type;
  entry->twice = false;
  entry->slot = slot;
  entry->have = have;
  entry->sender = sender;
  memcpy(entry->nonce, nonce, NONCE_LENGTH);
  added_ = true;
  trace::tell(static_cast<trace::Point>(trace::OWE_DELIVERED + (type - Proof::DELIVERED)), nonce[NONCE_LENGTH - 1],
              slot);
}

void Acknowledger::remove(Entry *entry) {
  end_--;
  memmove(entry, entry + 1, static_cast<size_t>(end_ - entry) * sizeof(Entry));
  if (entry != entries_) return;
  deferred_ = false;
  slots_ = FRESH_SLOTS;
}

// The first acknowledgement is the host's to cause.
void Acknowledger::answerTwice() {
  if (!added_ || end_[-1].type != Proof::DELIVERED) return;
  end_[-1].twice = true;
  trace::tell(trace::OWE_TWICE);
}

void Acknowledger::keysChanged() {
  for (Entry *entry = end_; entry-- != entries_;) {
    if (state_->keys.isFree(entry->slot)) remove(entry);
  }
}

void Acknowledger::run() {
  if (end_ == entries_) return;
  noteBusyAir();
  if (medium_->quietSlots() < slots_) return;
  uint8_t frame[HEADER_LENGTH + Proof::MAX_BODY_LENGTH + PROOF_LENGTH];
  const uint8_t length = build(entries_[0], frame);
  if (length != 0 && !medium_->send(frame, length)) return;
  if (length != 0) trace::tell(trace::ANSWER, entries_[0].slot);
  if (length != 0 && entries_[0].twice) {
    entries_[0].twice = false;
  } else {
    remove(entries_);
  }
}

void Acknowledger::noteCarrier(bool &deferred) {
  if (deferred || !medium_->hearsCarrier()) return;
  deferred = true;
  state_->count(Counter::RADIO_DEFERRED);
}

void Acknowledger::noteBusyAir() {
  noteCarrier(deferred_);
  if (medium_->isBusy() && slots_ == FRESH_SLOTS) {
    slots_ = static_cast<uint8_t>(LEAST_PUT_OFF_SLOTS + state_->random->next(FURTHER_SLOTS_MASK));
    trace::tell(trace::PUT_OFF, slots_);
  }
}

// Returns 0 where the key can no longer be read.
uint8_t Acknowledger::build(const Entry &entry, uint8_t *frame) const {
  const uint8_t bodyLength = Proof::bodyLength(entry.type);
  const uint8_t messageLength = static_cast<uint8_t>(bodyLength + PROOF_LENGTH);
  uint8_t *body = frame + HEADER_LENGTH;
  const uint16_t bits = static_cast<uint16_t>((entry.nonce[4] << 8 | entry.nonce[5]) & 0xFFF);
  Frame::writeHeader(frame, Address::acknowledgement(bits), state_->id.address(), messageLength);
  writeBody(entry, body);
  const Proof::Claim claim = {entry.type,           entry.nonce, entry.sender,
                              state_->id.address(), body,        asking_.has(entry.slot)};
  return prove(entry.slot, claim, body + bodyLength) ? static_cast<uint8_t>(HEADER_LENGTH + messageLength) : 0;
}

bool Acknowledger::prove(uint8_t slot, const Proof::Claim &claim, uint8_t *proof) const {
  DerivedKeys keys;
  if (!state_->keys.load(slot, keys)) return false;
  Proof(keys).make(claim, proof);
  return true;
}

void Acknowledger::writeBody(const Entry &entry, uint8_t *body) const {
  if (entry.type == Proof::FRAGMENTS) body[0] = entry.have;
  if (entry.type != Proof::STALE) return;
  const uint32_t uptime = clock::millis() / MILLIS_A_UNIT;
  const uint16_t told = uptime > UINT16_MAX ? UINT16_MAX : static_cast<uint16_t>(uptime);
  state_->replays.floor(entry.slot, entry.sender, body);
  body[NONCE_LENGTH] = static_cast<uint8_t>(told >> 8);
  body[NONCE_LENGTH + 1] = static_cast<uint8_t>(told);
}

}  // namespace javinolib
