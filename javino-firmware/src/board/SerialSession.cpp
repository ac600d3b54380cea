#include "SerialSession.h"

namespace javinolib {

bool SerialSession::isIdle() const {
  const bool canTakeMore = !requestWaits_ && port_.canRead();
  const bool canGiveMore = (requestWaits_ || !encoder_.done()) && port_.canWrite();
  return !canTakeMore && !canGiveMore;
}

void SerialSession::exchange() {
  while (!encoder_.done() && port_.canWrite()) port_.write(encoder_.next());
  while (!requestWaits_ && !replyOpen_ && port_.canRead()) add(decoder_.add(port_.read()));
}

void SerialSession::add(PacketEvent event) {
  if (event == PacketEvent::PACKET) {
    requestWaits_ = true;
  } else if (event != PacketEvent::NONE) {
    counters_.count(Counter::SERIAL_DAMAGED);
    // The host need not wait for as long as it lets a poll be held.
    if (encoder_.done()) askAgain();
  }
}

void SerialSession::askAgain() {
  ranAt_ = static_cast<uint16_t>(clock::millis());
  for (uint8_t i = 0; i != 3; i++) {
    if (port_.canWrite()) port_.write(i & 1);  // 0, and an empty packet
  }
}

// Returns whether the request is to be performed; a repeat is answered from memory. The zero tells the host that the request
// has come, and ends what a sketch may have printed on the line.
bool SerialSession::take(Request &request) {
  requestWaits_ = false;
  port_.write(0);
  if (!Request::parse(decoder_.frame(), decoder_.frameLength(), request)) {
    counters_.count(Counter::SERIAL_BAD_FRAMES);
    return false;
  }
  counters_.count(Counter::SERIAL_REQUESTS);
  if (isRepeat(request)) {
    counters_.count(Counter::SERIAL_REPEATS);
    encoder_.start(reply_.packet(), reply_.packetLength());
    return false;
  }
  reply_.begin(decoder_.sequence());
  lastSequence_ = decoder_.sequence();
  lastCrc_ = decoder_.crc();
  replyOpen_ = true;
  return true;
}

void SerialSession::send() {
  replyOpen_ = false;
  reply_.finish();
  // A sketch may have printed while a poll was held.
  port_.write(0);
  encoder_.start(reply_.packet(), reply_.packetLength());
}

bool SerialSession::isRepeat(const Request &request) const {
  return remembers_ && decoder_.sequence() == lastSequence_ && decoder_.crc() == lastCrc_ && !request.isHello();
}

}  // namespace javinolib
