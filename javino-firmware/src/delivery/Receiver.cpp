#include "Receiver.h"

#include "../support/Clock.h"

namespace javino {

void Receiver::run() {
  uint8_t length;
  while (uint8_t *packet = medium_.receive(length)) {
    accept(packet, length);
    medium_.release();
  }
  pieces_.run();
}

void Receiver::open(bool open) {
  open_ = open;
  if (!open) pieces_.clear();
}

void Receiver::accept(uint8_t *packet, uint8_t length) {
  Frame frame;
  if (Frame::parse(packet, length, frame) != FrameError::NONE || !frame.origin.isDevice()) {
    admission_.drop(Counter::RADIO_BAD_FRAMES);
  } else if (frame.destination.classOf() == Address::ACKNOWLEDGEMENT) {
    if (!courier_.acknowledged(frame)) admission_.drop(Counter::RADIO_NOT_FOR_US);
  } else if (!open_) {
    admission_.drop(Counter::RADIO_BLOCKED);
  } else {
    accept(frame, packet, length);
  }
}

void Receiver::accept(const Frame &frame, uint8_t *packet, uint8_t length) {
  const uint32_t begun = clock::millis() - medium_.airtimeMillis(length);
  if (frame.destination.classOf() == Address::PIECE) {
    if (admission_.isOwn(frame)) {
      admission_.drop(Counter::RADIO_OWN);
    } else {
      pieces_.accept(frame, medium_.pieceLength(), begun);
    }
  } else if (admission_.isForUs(frame)) {
    admission_.accept(frame, packet, length, begun);
  }
}

}  // namespace javino
