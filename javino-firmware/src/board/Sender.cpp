#include "Sender.h"

namespace javino {

Status Sender::send(const Frame &frame, uint8_t &number) {
  const Status addresses = checkAddresses(frame);
  if (addresses != Status::OK) return addresses;
  return frame.destination.isBroadcast() ? sendPlain(frame, number) : sendSealed(frame, number);
}

Status Sender::checkAddresses(const Frame &frame) const {
  if (!id_.isSet()) return Status::NO_RF_ID;
  if (frame.origin != id_.address()) return Status::WRONG_ORIGIN;
  const Address::Class to = frame.destination.classOf();
  const bool canBeSentTo = to == Address::DEVICE || to == Address::MULTICAST || to == Address::BROADCAST;
  return canBeSentTo && frame.destination != id_.address() ? Status::OK : Status::BAD_DESTINATION;
}

Status Sender::sendPlain(const Frame &frame, uint8_t &number) {
  if (frame.length > MAX_CONTENT_LENGTH) return Status::TOO_LONG;
  if (!outbox_.fits(static_cast<uint16_t>(HEADER_LENGTH + frame.length))) return Status::QUEUE_FULL;
  number = outbox_.addPlain(frame);
  return Status::OK;
}

Status Sender::sendSealed(const Frame &frame, uint8_t &number) {
  if (keys_.current(frame.destination) == KeyStore::NO_SLOT) return Status::NO_KEY;
  if (frame.length > MAX_CONTENT_LENGTH) return Status::TOO_LONG;
  if (!outbox_.fits(static_cast<uint16_t>(HEADER_LENGTH + SEAL_LENGTH + frame.length))) return Status::QUEUE_FULL;
  const Status status = nonces_.status();
  if (status == Status::OK) number = outbox_.addUnsealed(frame);
  return status;
}

}  // namespace javino
