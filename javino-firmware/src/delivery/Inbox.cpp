#include "Inbox.h"

#include "../secure/BoardState.h"
#include "../support/Trace.h"

#include <string.h>

namespace javinolib {

const uint8_t Inbox::DESTINATION_AT;
const uint8_t Inbox::ORIGIN_AT;
const uint8_t Inbox::NONCE_AT;
const uint8_t Inbox::HEAD_LENGTH;

void Inbox::add(uint8_t slot, const uint8_t *frame, Length length) {
  uint8_t *const record = records_.append(static_cast<Length>(HEAD_LENGTH + length));
  uint8_t *into = record + NONCE_AT;
  record[0] = slot;
  memcpy(record + DESTINATION_AT, frame, 2 * Address::TEXT_LENGTH);
  frame += HEADER_LENGTH;
  uint8_t nonce = 0;
  if (slot == KeyStore::NO_SLOT) {
    memset(into, 0, NONCE_LENGTH);
    into += NONCE_LENGTH;
  } else {
    length = static_cast<Length>(NONCE_LENGTH + length);
    nonce = frame[NONCE_LENGTH - 1];
  }
  trace::tell(trace::QUEUED, nonce, slot);
  memmove(into, frame, length);
}

Inbox::Waiting Inbox::waiting(uint8_t slot, const Address &origin, const uint8_t *nonce) const {
  Waiting waiting = NOTHING;
  uint8_t text[Address::TEXT_LENGTH];
  origin.write(text);
  for (ByteQueue::Record record = first(); record.bytes != nullptr; record = after(record)) {
    if (record.bytes[0] != slot || memcmp(record.bytes + ORIGIN_AT, text, sizeof text) != 0) continue;
    const int order = memcmp(record.bytes + NONCE_AT, nonce, NONCE_LENGTH);
    if (order == 0) return THIS;
    if (order > 0) waiting = LATER;
  }
  return waiting;
}

template <typename Scope>
void Inbox::taken(uint8_t number) {
  const uint8_t index = static_cast<uint8_t>(number - firstNumber_);
  if (index >= records_.count()) return;
  firstNumber_ = static_cast<uint8_t>(number + 1);
  trace::tell(trace::TAKEN, number);
  for (uint8_t left = static_cast<uint8_t>(index + 1); left != 0; left--) {
    uint8_t *const record = records_.first().bytes;
    settle<Scope>(record);
    records_.remove(record);
  }
}

template <typename Scope>
void Inbox::settle(const uint8_t *record) {
  const uint8_t slot = record[0];
  if (slot == KeyStore::NO_SLOT) return;
  Address destination, origin;
  Address::parse(record + DESTINATION_AT, destination);
  Address::parse(record + ORIGIN_AT, origin);
  replays_->remember<Scope>(slot, origin, record + NONCE_AT);
  if (destination.isDevice()) acknowledger_->delivered(slot, origin, record + NONCE_AT);
}

void Inbox::keysChanged(const KeyStore &keys) {
  for (ByteQueue::Record record = first(); record.bytes != nullptr; record = after(record)) {
    uint8_t &slot = record.bytes[0];
    if (slot != KeyStore::NO_SLOT && keys.isFree(slot)) slot = KeyStore::NO_SLOT;
  }
}

Inbox::Message Inbox::read(ByteQueue::Record record) {
  const Message message = {record.bytes + DESTINATION_AT, record.bytes + NONCE_AT, record.bytes + HEAD_LENGTH,
                           static_cast<Length>(record.length - HEAD_LENGTH)};
  return message;
}

template void Inbox::taken<WholeScope>(uint8_t);
template void Inbox::taken<UnicastScope>(uint8_t);

}  // namespace javinolib
