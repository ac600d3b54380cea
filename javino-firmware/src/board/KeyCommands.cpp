#include "KeyCommands.h"

namespace javino {

namespace {

const uint8_t SET_LENGTH = Address::TEXT_LENGTH + Aes128::KEY_LENGTH;

// Reads an address that can have a key.
bool parseAddress(const uint8_t *text, Address &into) {
  return Address::parse(text, into) && (into.isDevice() || into.isMulticast());
}

}  // namespace

Status KeyCommands::set(const uint8_t *body, uint16_t length, Reply &reply) {
  Address address;
  if (length != SET_LENGTH || !parseAddress(body, address)) return Status::BAD_ARGUMENT;
  const KeyStore::Result result = keys_.set(address, body + Address::TEXT_LENGTH);
  if (result == KeyStore::FULL) return Status::STORE_FULL;
  if (result == KeyStore::FAILED) return Status::STORE_FAILED;
  const uint8_t slot = keys_.find(address);
  if (result == KeyStore::STORED) receiver_.keyChanged(slot);
  addCheckValue(slot, reply);
  return Status::OK;
}

Status KeyCommands::erase(const uint8_t *body, uint16_t length) {
  Address address;
  if (length != Address::TEXT_LENGTH || !parseAddress(body, address)) return Status::BAD_ARGUMENT;
  const uint8_t slot = keys_.find(address);
  if (slot == KeyStore::NO_SLOT) return Status::NO_KEY;
  if (!keys_.erase(slot)) return Status::STORE_FAILED;
  receiver_.keyChanged(slot);
  return Status::OK;
}

Status KeyCommands::list(uint16_t length, Reply &reply) {
  if (length != 0) return Status::BAD_ARGUMENT;
  for (uint8_t slot = 0; slot < KeyStore::SLOTS; slot++) {
    const Address &address = keys_.addressAt(slot);
    if (address.isSerial()) continue;
    uint8_t text[Address::TEXT_LENGTH];
    address.write(text);
    reply.add(text, sizeof text);
    addCheckValue(slot, reply);
  }
  return Status::OK;
}

void KeyCommands::addCheckValue(uint8_t slot, Reply &reply) const {
  uint8_t check[DerivedKeys::CHECK_LENGTH];
  keys_.readCheckValue(slot, check);
  reply.add(check, sizeof check);
}

}  // namespace javino
