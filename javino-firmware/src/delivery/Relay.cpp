#include "Relay.h"

#include "../support/Clock.h"

namespace javinolib {

bool Relay::begin(uint16_t number) {
  random_->seed(number, 0);
  forwarding_.relay(&memory_);
  return medium_->begin() && medium_->canRelay();
}

void Relay::run() {
  medium_->update();
  Received with;
  while (const uint8_t *packet = medium_->receive(with)) {
    Frame frame;
    if (Frame::parse(packet, with.length, frame) == FrameError::NONE && frame.origin.isDevice()) {
      forwarding_.heard(frame, packet, with.length, with.path);
    }
    medium_->release();
  }
  forwarding_.run();
  for (; static_cast<uint16_t>(clock::millis() - secondSince_) >= 1000;
       secondSince_ = static_cast<uint16_t>(secondSince_ + 1000)) {
    seconds_++;
  }
}

}  // namespace javinolib
