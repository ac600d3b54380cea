#include "SerialSession.h"

namespace javinolib {

static const uint8_t FLAGS_AT = 1 + HEADER_LENGTH + 1;  // of a poll, in its packet behind the command

bool SerialSession::isIdle() const {
  const bool canGiveMore = (requestWaits_ || !encoder_.done()) && port_.canWrite();
  return !mayRead() && !canGiveMore;
}

void SerialSession::exchange() {
  while (!encoder_.done() && port_.canWrite()) port_.write(encoder_.next());
  while (!replyOpen_ && mayRead()) add(decoder_.add(port_.read()));
}

void SerialSession::add(PacketEvent event) {
  if (event == PacketEvent::PACKET) {
    requestWaits_ = true;
  } else if (event != PacketEvent::NONE) {
    counters_->count(Counter::SERIAL_DAMAGED);
    // The host need not wait for as long as it lets a poll be held.
    if (encoder_.done()) askAgain();
  }
}

void SerialSession::askAgain() {
  for (uint8_t i = 0; i != 3; i++) {
    if (port_.canWrite()) port_.write(i & 1);  // 0, and an empty packet
  }
}

// Returns whether the request is to be performed. A repeat is answered from memory; but if its reply was long, it has asked
// something, and is asked again: a poll is told what it was told. The zero tells the host that the request has come, and ends
// what a sketch may have printed on the line.
bool SerialSession::take(Request &request) {
  requestWaits_ = false;
  port_.write(0);
  if (!Request::parse(decoder_.frame(), decoder_.frameLength(), request)) {
    counters_->count(Counter::SERIAL_BAD_FRAMES);
    return false;
  }
  counters_->count(Counter::SERIAL_REQUESTS);
  if (isRepeat(request)) {
    counters_->count(Counter::SERIAL_REPEATS);
    if (reply_.recall()) {
      encoder_.start(reply_.packet(), reply_.packetLength());
      return false;
    }
    if (*request.message() == Request::POLL) reply_.packet()[FLAGS_AT] |= Poll::REPLY_LOST;
  }
  reply_.begin();
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
