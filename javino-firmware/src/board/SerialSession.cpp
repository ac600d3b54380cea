#include "SerialSession.h"

namespace javinolib {

SerialSession::SerialSession(SerialPort port, Commands &commands, Poll &poll, Counters &counters)
    : port_(port), commands_(commands), poll_(poll), counters_(counters) {}

void SerialSession::run() {
  finish();
  write();
  read();
  while (requestWaits_ && encoder_.done()) {
    requestWaits_ = false;
    answer();
    finish();
    write();
    read();
  }
}

bool SerialSession::isIdle() const {
  const bool canTakeMore = !requestWaits_ && port_.canRead();
  const bool canGiveMore = !encoder_.done() && port_.canWrite();
  return !canTakeMore && !canGiveMore && !(requestWaits_ && encoder_.done()) && !poll_.canTell();
}

void SerialSession::read() {
  while (!requestWaits_ && !replyOpen_ && port_.canRead()) take(decoder_.add(port_.read()));
}

void SerialSession::take(PacketEvent event) {
  if (event == PacketEvent::PACKET) {
    requestWaits_ = true;
  } else if (event != PacketEvent::NONE) {
    counters_.count(Counter::SERIAL_DAMAGED);
    // The host need not wait for as long as it lets a poll be held.
    if (encoder_.done() && port_.canWrite()) port_.write(0);
  }
}

void SerialSession::answer() {
  Frame request;
  if (Frame::parse(decoder_.frame(), decoder_.frameLength(), request) != FrameError::NONE) {
    counters_.count(Counter::SERIAL_BAD_FRAMES);
    return;
  }
  counters_.count(Counter::SERIAL_REQUESTS);
  if (isRepeat(request)) {
    counters_.count(Counter::SERIAL_REPEATS);
    encoder_.start(reply_.packet(), reply_.packetLength());
  } else {
    reply_.begin(decoder_.sequence());
    remembers_ = commands_.perform(request, reply_);
    lastSequence_ = decoder_.sequence();
    lastCrc_ = decoder_.crc();
    replyOpen_ = true;
  }
}

void SerialSession::finish() {
  if (!replyOpen_ || !poll_.answer(reply_, port_.canRead())) return;
  replyOpen_ = false;
  reply_.finish();
  encoder_.start(reply_.packet(), reply_.packetLength());
}

bool SerialSession::isRepeat(const Frame &request) const {
  return remembers_ && decoder_.sequence() == lastSequence_ && decoder_.crc() == lastCrc_ &&
         !Commands::isAlwaysPerformed(request);
}

void SerialSession::write() {
  while (!encoder_.done() && port_.canWrite()) port_.write(encoder_.next());
}

}  // namespace javinolib
