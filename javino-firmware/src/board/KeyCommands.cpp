#include "KeyCommands.h"

namespace javino {

namespace {

const uint8_t STORE_LENGTH = Address::TEXT_LENGTH + Aes128::KEY_LENGTH;

enum Role : uint8_t { CURRENT = 0, PREVIOUS = 1 };  // SPEC 4.3

// Reads an address that can have a key.
bool parseAddress(const uint8_t *text, Address &into) {
  return Address::parse(text, into) && (into.isDevice() || into.isMulticast());
}

bool parseAddress(const uint8_t *body, uint16_t length, Address &into) {
  return length == Address::TEXT_LENGTH && parseAddress(body, into);
}

}  // namespace

Status KeyCommands::set(const uint8_t *body, uint16_t length, Reply &reply) {
  return store(&KeyStore::set, body, length, reply);
}

Status KeyCommands::renew(const uint8_t *body, uint16_t length, Reply &reply) {
  return store(&KeyStore::renew, body, length, reply);
}

Status KeyCommands::store(Change change, const uint8_t *body, uint16_t length, Reply &reply) {
  Address address;
  if (length != STORE_LENGTH || !parseAddress(body, address)) return Status::BAD_ARGUMENT;
  const KeyStore::Result result = (keys_.*change)(address, body + Address::TEXT_LENGTH);
  const bool forgotten = replays_.forgetLostKeys(keys_);
  if (result == KeyStore::IS_PREVIOUS) return Status::BAD_ARGUMENT;
  if (result == KeyStore::FULL) return Status::STORE_FULL;
  if (result == KeyStore::FAILED || !forgotten) return Status::STORE_FAILED;
  addCheckValue(keys_.current(address), reply);
  return Status::OK;
}

Status KeyCommands::finish(const uint8_t *body, uint16_t length) {
  Address address;
  if (!parseAddress(body, length, address)) return Status::BAD_ARGUMENT;
  const uint8_t previous = keys_.previous(address);
  if (previous == KeyStore::NO_SLOT) return Status::NO_KEY;
  return erase(previous) ? Status::OK : Status::STORE_FAILED;
}

// The previous key goes first: a loss of power between the two must not bring it back.
Status KeyCommands::erase(const uint8_t *body, uint16_t length) {
  Address address;
  if (!parseAddress(body, length, address)) return Status::BAD_ARGUMENT;
  const uint8_t current = keys_.current(address);
  const uint8_t previous = keys_.previous(address);
  if (current == KeyStore::NO_SLOT) return Status::NO_KEY;
  if (previous != KeyStore::NO_SLOT && !erase(previous)) return Status::STORE_FAILED;
  return erase(current) ? Status::OK : Status::STORE_FAILED;
}

Status KeyCommands::list(uint16_t length, Reply &reply) {
  if (length != 0) return Status::BAD_ARGUMENT;
  for (uint8_t slot = 0; slot < KeyStore::SLOTS; slot++) {
    const Address &address = keys_.addressAt(slot);
    if (keys_.isFree(slot)) continue;
    uint8_t entry[Address::TEXT_LENGTH + 1];
    address.write(entry);
    entry[Address::TEXT_LENGTH] = slot == keys_.current(address) ? CURRENT : PREVIOUS;
    reply.add(entry, sizeof entry);
    addCheckValue(slot, reply);
  }
  return Status::OK;
}

bool KeyCommands::erase(uint8_t slot) { return keys_.erase(slot) && replays_.forget(slot); }

void KeyCommands::addCheckValue(uint8_t slot, Reply &reply) const {
  uint8_t check[DerivedKeys::CHECK_LENGTH];
  keys_.readCheckValue(slot, check);
  reply.add(check, sizeof check);
}

}  // namespace javino
