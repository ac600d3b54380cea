#include "KeyCommands.h"

#include "../secure/BoardState.h"

#include <string.h>

#include "../support/BigEndian.h"

namespace javinolib {

namespace {

const uint8_t STORE_LENGTH = Address::TEXT_LENGTH + Aes128::KEY_LENGTH;

enum Role : uint8_t { CURRENT = 0, PREVIOUS = 1, NEXT = 2, SESSION = 3 };  // SPEC 4.3

const uint8_t DOUBTFUL = 4;  // added to a role where floors of the key may be lost

const uint8_t EPOCH_LENGTH = 3;

// Reads an address that can have a key.
bool parseAddress(const uint8_t *text, Address &into) {
  return Address::parse(text, into) && (into.isDevice() || into.isMulticast());
}

}  // namespace

Status KeyCommands::raiseEpoch(const uint8_t *body, Length length) {
  if (length != EPOCH_LENGTH || (body[0] & body[1] & body[2]) == 0xFF) return Status::BAD_ARGUMENT;
  nonces_->raiseEpoch(readUint24(body));
  return nonces_->status();
}

template <typename Scope>
Status KeyCommands::store(bool renews, const uint8_t *body, Length length, Reply &reply) {
  Address address;
  if (length != STORE_LENGTH || !parseAddress(body, address)) return Status::BAD_ARGUMENT;
  if (!Scope::MANY && !address.isDevice()) return Status::UNICASTS_ONLY;
  if (Scope::MANY && isOneMorePair(renews, address) && !replays_->hasPlaceForPair()) return Status::STORE_FULL;
  const Status status = keys_->store<Scope>(address, body + Address::TEXT_LENGTH, renews);
  const bool forgotten = replays_->forgetLostKeys();
  if (status != Status::OK) return status;
  if (!forgotten) return Status::STORE_FAILED;
  const uint8_t next = Scope::RENEWS ? keys_->next(address) : KeyStore::NO_SLOT;
  addCheckValue(next == KeyStore::NO_SLOT ? keys_->current(address) : next, reply);
  return Status::OK;
}

// Whether a change makes one key more of a pair, which needs a place of its own in the replay memory.
bool KeyCommands::isOneMorePair(bool renews, const Address &address) const {
  if (!address.isDevice()) return false;
  const uint8_t slot = renews ? keys_->other(address) : keys_->current(address);
  return slot == KeyStore::NO_SLOT || KeyStore::isSession(slot);
}

template <typename Scope>
Status KeyCommands::change(Change change, const uint8_t *body, Length length, const Delivery &delivery) {
  Address address;
  if (length != Address::TEXT_LENGTH || !parseAddress(body, address)) return Status::BAD_ARGUMENT;
  const uint8_t current = keys_->current(address);
  if (!Scope::RENEWS) {
    if (current == KeyStore::NO_SLOT) return Status::NO_KEY;
    for (uint8_t slot = current; slot != KeyStore::NO_SLOT; slot = keys_->current(address)) {
      if (!erase(slot)) return Status::STORE_FAILED;
    }
    return Status::OK;
  }
  const uint8_t other = keys_->other(address);
  const uint8_t next = keys_->next(address);
  if (change == USE) {
    return next != KeyStore::NO_SLOT && delivery.isUnderWay(current) ? Status::BUSY : keys_->use(address);
  }
  if (change == FINISH) {
    // a cell may read wrong once
    if (other == KeyStore::NO_SLOT || other == next || other != keys_->other(address)) return Status::NO_KEY;
    return erase(other) ? Status::OK : Status::STORE_FAILED;
  }
  if (current == KeyStore::NO_SLOT) return Status::NO_KEY;
  // The other key goes first: a loss of power between the two must not bring it back, nor into use.
  return (other == KeyStore::NO_SLOT || erase(other)) && erase(current) ? Status::OK : Status::STORE_FAILED;
}

template <typename Scope>
Status KeyCommands::setSession(const uint8_t *body, Length length, Delivery &delivery, Reply &reply) {
  Address device;
  if (length != STORE_LENGTH || !parseAddress(body, device) || !device.isDevice()) return Status::BAD_ARGUMENT;
  const uint8_t *const key = body + Address::TEXT_LENGTH;
  DerivedKeys derived;
  derived.derive(key);
  uint8_t slot = keys_->current(device);
  if (slot != KeyStore::NO_SLOT && !KeyStore::isSession(slot)) return Status::HAS_KEY;
  if (slot == KeyStore::NO_SLOT ||
      memcmp(key, keys_->sessions().keyAt(static_cast<uint8_t>(slot - KeyStore::SLOTS)), Aes128::KEY_LENGTH) != 0) {
    if (keys_->sessions().had(derived.check)) return Status::BAD_ARGUMENT;
    if (slot == KeyStore::NO_SLOT) slot = placeForSession(delivery.outbox());
    if (!keys_->isFree(slot)) {
      erase(slot);
      delivery.keysChanged<Scope>();
    }
    keys_->setSession(slot, device, key, derived.check);
  }
  reply.add(derived.check, sizeof derived.check);
  return Status::OK;
}

// A free one, or that of the key that was used least recently: rather one with which nothing is to be sent.
uint8_t KeyCommands::placeForSession(const Outbox &outbox) const {
  uint8_t chosen = KeyStore::SLOTS;
  uint8_t most = 0;
  for (uint8_t i = 0; config::SESSION_KEYS > 1 && i != config::SESSION_KEYS; i++) {
    const uint8_t slot = static_cast<uint8_t>(KeyStore::SLOTS + i);
    if (keys_->isFree(slot)) return slot;
    uint8_t age = static_cast<uint8_t>(1 + keys_->sessions().ageOf(i));
    if (!outbox.hasFor(keys_->addressAt(slot))) age = static_cast<uint8_t>(age + config::SESSION_KEYS);
    if (age <= most) continue;
    most = age;
    chosen = slot;
  }
  return chosen;
}

template <typename Scope>
Status KeyCommands::list(Length length, Reply &reply) {
  if (length != 0) return Status::BAD_ARGUMENT;
  for (uint8_t slot = 0; slot < KeyStore::PLACES; slot++) {
    const Address &address = keys_->addressAt(slot);
    if (keys_->isFree(slot)) continue;
    uint8_t entry[Address::TEXT_LENGTH + 1];
    address.write(entry);
    entry[Address::TEXT_LENGTH] = KeyStore::isSession(slot)                           ? SESSION
                                  : !Scope::RENEWS || slot == keys_->current(address) ? CURRENT
                                  : slot == keys_->next(address)                      ? NEXT
                                                                                      : PREVIOUS;
    if (replays_->isDoubtful(slot)) entry[Address::TEXT_LENGTH] |= DOUBTFUL;
    reply.add(entry, sizeof entry);
    addCheckValue(slot, reply);
  }
  return Status::OK;
}

template Status KeyCommands::store<WholeScope>(bool, const uint8_t *, Length, Reply &);
template Status KeyCommands::store<UnicastScope>(bool, const uint8_t *, Length, Reply &);
template Status KeyCommands::change<WholeScope>(Change, const uint8_t *, Length, const Delivery &);
template Status KeyCommands::change<UnicastScope>(Change, const uint8_t *, Length, const Delivery &);
template Status KeyCommands::list<WholeScope>(Length, Reply &);
template Status KeyCommands::list<UnicastScope>(Length, Reply &);

bool KeyCommands::erase(uint8_t slot) { return keys_->erase(slot) && replays_->forget(slot); }

void KeyCommands::addCheckValue(uint8_t slot, Reply &reply) const {
  uint8_t check[DerivedKeys::CHECK_LENGTH];
  keys_->readCheckValue(slot, check);
  reply.add(check, sizeof check);
}

template Status KeyCommands::setSession<WholeScope>(const uint8_t *, Length, Delivery &, Reply &);
template Status KeyCommands::setSession<UnicastScope>(const uint8_t *, Length, Delivery &, Reply &);

}  // namespace javinolib
