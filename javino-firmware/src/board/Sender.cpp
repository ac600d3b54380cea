#include "Sender.h"

#include <string.h>

#include "../secure/Envelope.h"

namespace javino {

Status Sender::send(const Frame &frame, uint8_t &number) {
  const Status addresses = checkAddresses(frame);
  if (addresses != Status::OK) return addresses;
  return frame.destination.isBroadcast() ? sendPlain(frame, number) : sendSealed(frame, number);
}

Status Sender::checkAddresses(const Frame &frame) const {
  if (!id_.isSet()) return Status::NO_RF_ID;
  if (frame.origin != id_.address()) return Status::WRONG_ORIGIN;
  if (frame.destination.classOf() == Address::RESERVED || frame.destination == id_.address()) {
    return Status::BAD_DESTINATION;
  }
  return Status::OK;
}

Status Sender::sendPlain(const Frame &frame, uint8_t &number) {
  if (frame.length > MAX_PLAIN_RADIO_CONTENT) return Status::TOO_LONG;
  if (transmitter_.isFull()) return Status::QUEUE_FULL;
  uint8_t *packet = transmitter_.next();
  Frame::writeHeader(packet, frame.destination, frame.origin, frame.length);
  memcpy(packet + HEADER_LENGTH, frame.message, frame.length);
  number = transmitter_.commit(static_cast<uint8_t>(HEADER_LENGTH + frame.length));
  return Status::OK;
}

Status Sender::sendSealed(const Frame &frame, uint8_t &number) {
  DerivedKeys keys;
  const uint8_t slot = keys_.find(frame.destination);
  if (slot == KeyStore::NO_SLOT || !keys_.load(slot, keys)) return Status::NO_KEY;
  if (frame.length > MAX_SEALED_RADIO_CONTENT) return Status::TOO_LONG;
  if (transmitter_.isFull()) return Status::QUEUE_FULL;
  if (nonces_.isExhausted()) return Status::NONCE_EXHAUSTED;
  if (!nonces_.isStored()) return Status::STORE_FAILED;
  uint8_t nonce[NONCE_LENGTH];
  nonces_.take(nonce);
  const uint16_t length = Envelope(keys).seal(frame, nonce, transmitter_.next());
  number = transmitter_.commit(static_cast<uint8_t>(length));
  return Status::OK;
}

}  // namespace javino
