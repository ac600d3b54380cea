#include "Receiver.h"

#include <string.h>

#include "../secure/Envelope.h"

namespace javino {

void Receiver::run() {
  uint8_t packet[MAX_RADIO_PAYLOAD];
  while (const uint8_t length = radio_.receive(packet)) accept(packet, length);
}

void Receiver::accept(uint8_t *packet, uint8_t length) {
  Frame frame;
  if (Frame::parse(packet, length, frame) != FrameError::NONE || !frame.origin.isDevice()) {
    drop(Counter::RADIO_BAD_FRAMES);
  } else if (!isForUs(frame)) {
    return;
  } else if (!frame.destination.isBroadcast()) {
    acceptSealed(frame, packet, length);
  } else if (queue_.isFull()) {
    drop(Counter::RADIO_QUEUE_FULL);
  } else {
    enqueue(frame, frame.message, frame.length);
  }
}

// Whether a board of our address accepts the frame; where not, it is counted.
bool Receiver::isForUs(const Frame &frame) {
  const Address &to = frame.destination;
  const Address &own = id_.address();
  switch (to.classOf()) {
    case Address::RESERVED:
    case Address::SERIAL_LINE:
      return drop(Counter::RADIO_RESERVED);
    case Address::DEVICE:
      if (to != own) return drop(Counter::RADIO_NOT_FOR_US);
      break;
    case Address::MULTICAST:
      if (!id_.isSet() || to.member() != own.group()) return drop(Counter::RADIO_NOT_FOR_US);
      break;
    case Address::BROADCAST:
      break;
  }
  return frame.origin != own || drop(Counter::RADIO_OWN);
}

bool Receiver::drop(Counter why) {
  counters_.count(why);
  return false;
}

void Receiver::acceptSealed(const Frame &frame, uint8_t *packet, uint8_t length) {
  DerivedKeys keys;
  const uint8_t slot = keys_.find(frame.destination.isMulticast() ? frame.destination : frame.origin);
  if (slot == KeyStore::NO_SLOT || !keys_.load(slot, keys)) {
    drop(Counter::RADIO_NO_KEY);
    return;
  }
  const Envelope envelope(keys);
  if (!envelope.isAuthentic(packet, length)) {
    drop(Counter::RADIO_BAD_TAG);
    return;
  }
  const uint8_t *nonce = packet + Envelope::NONCE_AT;
  const ReplayMemory::Verdict verdict = replays_.judge(slot, frame.origin, nonce);
  if (verdict != ReplayMemory::NEWER) {
    drop(verdict == ReplayMemory::FULL ? Counter::RADIO_REPLAY_FULL : Counter::RADIO_REPLAYED);
    return;
  }
  if (queue_.isFull()) {
    drop(Counter::RADIO_QUEUE_FULL);
    return;
  }
  if (!replays_.reserve(slot, frame.origin, nonce)) {
    drop(Counter::RADIO_REPLAY_FULL);
    return;
  }
  replays_.remember(slot, frame.origin, nonce);
  enqueue(frame, packet + Envelope::CONTENT_AT, envelope.open(packet, length));
}

void Receiver::enqueue(const Frame &frame, const uint8_t *content, uint16_t length) {
  ReceivedMessage &message = queue_.next();
  message.destination = frame.destination;
  message.origin = frame.origin;
  message.length = static_cast<uint8_t>(length);
  memcpy(message.content, content, length);
  queue_.commit();
}

}  // namespace javino
