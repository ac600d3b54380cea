#include "Relay.h"

#include "../radio/Mender.h"

namespace javinolib {

bool Relay::begin(uint16_t number) {
  random_.seed(number, 0);
  forwarding_.relay(&memory_);
  return medium_.begin() && medium_.canRelay();
}

void Relay::run() {
  medium_.update();
  uint8_t length;
  while (const uint8_t *packet = medium_.receive(length)) {
    Frame frame;
    if (Frame::parse(packet, length, frame) == FrameError::NONE && frame.origin.isDevice()) {
      forwarding_.heard(frame, packet, length, medium_.mender() ? medium_.mender()->hops() : 0);
    }
    medium_.release();
  }
  forwarding_.run();
}

}  // namespace javinolib
