#include "Broadcaster.h"

#include <string.h>

#include "../radio/Mender.h"
#include "../storage/KeyStore.h"
#include "../support/Counters.h"
#include "../support/Clock.h"
#include "../support/Trace.h"

namespace javinolib {

bool Broadcaster::begin(const char *address) {
  if (strlen(address) != Address::TEXT_LENGTH ||
      !Address::parse(reinterpret_cast<const uint8_t *>(address), address_) || !address_.isDevice()) {
    return false;
  }
  random_.seed(address_.value(), 0);
  return medium_.begin();
}

bool Broadcaster::send(const char *text) {
  const size_t length = strlen(text);
  if (isBusy() || length == 0 || length > medium_.fragmentLength()) return false;
  Frame::writeHeader(frame_, Address::broadcast(), address_, static_cast<uint16_t>(length));
  memcpy(frame_ + HEADER_LENGTH, text, length);
  length_ = static_cast<uint8_t>(HEADER_LENGTH + length);
  backoff_.begin(0, medium_.quietSlots(), random_);
  trace::tell(trace::TAKE_UP, KeyStore::NO_SLOT);
  trace::tell(trace::CONTEND, backoff_.left());
  return true;
}

void Broadcaster::run() {
  medium_.update();
  backoff_.listen(medium_.quietSlots());
  Received with;
  while (const uint8_t *packet = medium_.receive(with)) {
    if (medium_.mender() && medium_.mender()->isDoubtful()) {
      countUp(ignored_);
    } else {
      hear(packet, with);
    }
    medium_.release();
  }
  medium_.update();  // the sketch may have taken its time with what was heard
  if (!isBusy() || !backoff_.isOver(medium_.quietSlots()) || !medium_.send(frame_, length_)) return;
  trace::tell(trace::SEND, 1);
  length_ = 0;
  trace::tell(trace::SENT);  // once: nothing more is told of it
}

void Broadcaster::hear(const uint8_t *packet, const Received &with) {
  Frame frame;
  if (Frame::parse(packet, with.length, frame) != FrameError::NONE || !isNew(frame, packet, with)) {
    countUp(ignored_);
    return;
  }
  if (!hearer_) return;
  uint8_t from[Address::TEXT_LENGTH + 1] = {};
  char text[MAX_TEXT + 1] = {};
  frame.origin.write(from);
  memcpy(text, frame.message, frame.length);
  hearer_(reinterpret_cast<const char *>(from), text);
}

bool Broadcaster::isNew(const Frame &frame, const uint8_t *packet, const Received &with) {
  if (frame.length > MAX_TEXT || !frame.destination.isBroadcast() || !frame.origin.isDevice() ||
      frame.origin == address_)
    return false;
  return !heard_.isRepeat(packet, with.length, clock::millis(), medium_.begunMillis(with));
}

}  // namespace javinolib
