#include "FrameAcceptor.h"

#include "../support/Clock.h"

namespace javinolib {

template <typename Scope>
bool FrameAcceptor::isForUs(const Frame &frame) {
  const Address &to = frame.destination;
  const Address &own = state_->id.address();
  switch (to.kind()) {
    case Address::DEVICE:
      if (to != own) return drop(Counter::RADIO_NOT_FOR_US);
      break;
    case Address::MULTICAST:
      if (!Scope::MANY || !state_->id.isSet() || to.member() != own.group()) return drop(Counter::RADIO_NOT_FOR_US);
      break;
    case Address::BROADCAST:
      if (!Scope::MANY) return drop(Counter::RADIO_NOT_FOR_US);
      break;
    default: return drop(Counter::RADIO_RESERVED);
  }
  return !isOwn(frame) || drop(Counter::RADIO_OWN);
}

bool FrameAcceptor::drop(Counter why) {
  state_->count(why);
  return false;
}

template <typename Scope>
bool FrameAcceptor::accept(const Frame &frame, uint8_t *bytes, Length length, uint16_t age) {
  return Scope::MANY && frame.destination.isBroadcast() ? acceptBroadcast(frame, bytes, length, age)
                                                        : acceptSealed<Scope>(frame, bytes, length);
}

bool FrameAcceptor::acceptBroadcast(const Frame &frame, const uint8_t *bytes, Length length, uint16_t age) {
  if (broadcasts_->isRepeat(bytes, length, clock::millis(), age)) {
    state_->count(Counter::RADIO_REPEATS);
    return true;
  }
  if (!inbox_->fits(frame.length)) return drop(Counter::RADIO_QUEUE_FULL);
  inbox_->add(KeyStore::NO_SLOT, bytes, frame.length);
  return true;
}

// While a key is being renewed a frame may be sealed with either.
template <typename Scope>
bool FrameAcceptor::acceptSealed(const Frame &frame, uint8_t *bytes, Length length) {
  bool hasKey = false;
  for (uint8_t other = 0; other < (Scope::RENEWS ? KeyStore::KEYS_OF_ADDRESS : 1); other++) {
    DerivedKeys keys;
    const uint8_t slot = slotOf<Scope>(frame, other != 0);
    if (!state_->keys.load(slot, keys)) continue;
    hasKey = true;
    const Envelope envelope(keys);
    if (envelope.isAuthentic(bytes, length)) return acceptUnder<Scope>(slot, envelope, frame, bytes, length);
  }
  return hasKey ? drop(Counter::RADIO_BAD_TAG) : dropWithoutKey(frame);
}

// Counts a frame that cannot be opened, and has the host told of it.
bool FrameAcceptor::dropWithoutKey(const Frame &frame) {
  inbox_->unknownKeys().add(frame);
  return drop(Counter::RADIO_NO_KEY);
}

bool FrameAcceptor::isGenuine(const Frame &frame, const uint8_t *bytes, Length length) const {
  if (frame.destination.isBroadcast()) return true;
  for (uint8_t previous = 0; previous < KeyStore::KEYS_OF_ADDRESS; previous++) {
    DerivedKeys keys;
    if (state_->keys.load(slotOf(frame, previous != 0), keys) && Envelope(keys).isAuthentic(bytes, length)) return true;
  }
  return false;
}

template <typename Scope>
uint8_t FrameAcceptor::slotOf(const Frame &frame, bool other) const {
  const Address &with = Scope::MANY && frame.destination.isMulticast() ? frame.destination : frame.origin;
  return Scope::RENEWS && other ? state_->keys.other(with) : state_->keys.current(with);
}

template <typename Scope>
bool FrameAcceptor::acceptUnder(uint8_t slot, const Envelope &envelope, const Frame &frame, uint8_t *bytes,
                                Length length) {
  acknowledger_->heard(slot);
  const uint8_t *nonce = bytes + Envelope::NONCE_AT;
  const ReplayMemory::Verdict verdict = state_->replays.judge<Scope>(slot, frame.origin, nonce);
  if (verdict != ReplayMemory::NEWER) return refuse(verdict, slot, frame, nonce);
  switch (inbox_->waiting(slot, frame.origin, nonce)) {
    case Inbox::THIS: state_->count(Counter::RADIO_REPEATS); return true;
    case Inbox::LATER: return drop(Counter::RADIO_REPLAYED);
    case Inbox::NOTHING: break;
  }
  if (!inbox_->fits(static_cast<Length>(length - Envelope::MIN_FRAME_LENGTH))) return drop(Counter::RADIO_QUEUE_FULL);
  if (!state_->replays.reserve<Scope>(slot, frame.origin, nonce)) return drop(Counter::RADIO_REPLAY_FULL);
  state_->keys.used(slot);
  inbox_->add(slot, bytes, envelope.open(bytes, length));
  return true;
}

// Returns whether the message is here already.
bool FrameAcceptor::refuse(ReplayMemory::Verdict verdict, uint8_t slot, const Frame &frame, const uint8_t *nonce) {
  switch (verdict) {
    case ReplayMemory::REPEATED:
      state_->count(Counter::RADIO_REPEATS);
      if (frame.destination.isDevice()) acknowledger_->delivered(slot, frame.origin, nonce);
      return true;
    case ReplayMemory::BELOW_FLOOR:
      acknowledger_->tellFloor(slot, frame.origin, nonce);
      return drop(Counter::RADIO_STALE);
    case ReplayMemory::FULL: return drop(Counter::RADIO_REPLAY_FULL);
    case ReplayMemory::DAMAGED: return drop(Counter::MEMORY_DAMAGED);
    default: return drop(Counter::RADIO_REPLAYED);
  }
}

bool FrameAcceptor::needsMore(const Frame &frame, const uint8_t *nonce, bool wantsAnswer) {
  bool hasKey = false;
  for (uint8_t other = 0; other < KeyStore::KEYS_OF_ADDRESS; other++) {
    const uint8_t slot = slotOf(frame, other != 0);
    if (slot == KeyStore::NO_SLOT) continue;
    hasKey = true;
    const bool taken = state_->replays.judge(slot, frame.origin, nonce) == ReplayMemory::REPEATED;
    if (!taken && inbox_->waiting(slot, frame.origin, nonce) != Inbox::THIS) continue;
    if (taken && wantsAnswer && frame.destination.isDevice()) {
      acknowledger_->heard(slot);
      acknowledger_->delivered(slot, frame.origin, nonce);
    }
    return drop(Counter::RADIO_REPEATS);
  }
  return hasKey || dropWithoutKey(frame);
}

void FrameAcceptor::answerFragment(const Frame &frame, const uint8_t *nonce, uint8_t have) {
  for (uint8_t other = 0; other < KeyStore::KEYS_OF_ADDRESS; other++) {
    const uint8_t slot = slotOf(frame, other != 0);
    if (slot == KeyStore::NO_SLOT) continue;
    acknowledger_->heard(slot);
    acknowledger_->fragments(slot, frame.origin, nonce, have);
  }
}

template bool FrameAcceptor::isForUs<WholeScope>(const Frame &);
template bool FrameAcceptor::isForUs<UnicastScope>(const Frame &);
template bool FrameAcceptor::accept<WholeScope>(const Frame &, uint8_t *, Length, uint16_t);
template bool FrameAcceptor::accept<UnicastScope>(const Frame &, uint8_t *, Length, uint16_t);

}  // namespace javinolib
