#include "Receiver.h"

#include "../radio/Mender.h"

namespace javinolib {

template <typename Scope>
void Receiver::run() {
  const Mender *const mender = medium_->mender();
  Received with;
  while (uint8_t *packet = medium_->receive(with)) {
    doubtful_ = mender && mender->isDoubtful();
    acknowledger_->heard(KeyStore::NO_SLOT);
    captured_->add(mender && mender->hasMended() ? CapturedPackets::MENDED : CapturedPackets::INTACT, packet,
                   with.length);
    accept<Scope>(packet, with);
    if (config::LARGE && mender && mender->hasMended()) {
      if (mender->trailer() != Trailer::NONE) {
        acknowledger_->askForParity();
      } else {
        acknowledger_->answerTwice();
      }
    }
    medium_->release();
  }
  if (mender && mender->lost()) {
    acknowledger_->heard(KeyStore::NO_SLOT);
    captured_->add(*mender->lost());
    if (config::LARGE) retransmitter_->acknowledged<Scope>(*mender->lost());
    medium_->release();
  }
  // The mark of an intact packet comes when that has been handled; it is another's if another waits.
  if (config::LARGE && mender && medium_->isIdle() && mender->lastTrailer() == Trailer::MARK)
    acknowledger_->askForParity();
  fragments_.run();
}

void Receiver::keep() {
#if JAVINO_LARGE
  if (medium_->mender()) medium_->mender()->keep();
#endif
}

void Receiver::forget() {
#if JAVINO_LARGE
  if (medium_->mender()) medium_->mender()->forget();
#endif
}

void Receiver::relay(bool on) {
  BoardsForwarding::Memory *memory = on ? fragments_.lend() : nullptr;
  forwarding_.relay(memory);
#if JAVINO_LARGE
  retransmitter_->relay(memory ? &memory->distances : nullptr);
#endif
  if (!on) fragments_.takeBack();
}

void Receiver::open(bool open) {
  open_ = open;
  if (!open) fragments_.clear();
}

template <typename Scope>
void Receiver::accept(uint8_t *packet, const Received &with) {
  Frame frame;
  if (Frame::parse(packet, with.length, frame) != FrameError::NONE || !frame.origin.isDevice()) {
    acceptor_->drop(Counter::RADIO_BAD_FRAMES);
    return;
  }
  if (config::LARGE && !acceptor_->isOwn(frame)) {
    forwarding_.heard(frame, packet, with.length, with.path, acceptor_->isFor(frame.destination));
  }
  const Address::Kind to = frame.destination.kind();
  if (to == Address::ACKNOWLEDGEMENT) {
    if (retransmitter_->acknowledged<Scope>(frame)) return;
    acceptor_->drop(Counter::RADIO_NOT_FOR_US);
    if (config::LARGE && with.path == 0 && frame.length == PROOF_LENGTH) retransmitter_->otherAcknowledged();
    return;
  }
  if (to == Address::DEVICE) retransmitter_->copied(packet, with.length);
  if (!open_) {
    acceptor_->drop(Counter::RADIO_BLOCKED);
  } else {
    accept<Scope>(frame, packet, with);
  }
}

static bool isWord(const Frame &frame) { return frame.length != 0 && (frame.message[0] & 0xC0) == 0x80; }

// Whether it is a word of hosts (SPEC 3), which these prove, or take for what anybody may have said.
bool Receiver::mayBeDoubtful(const Frame &frame) const { return config::LARGE && isWord(frame); }

// A sealed frame is kept before it is opened, so that a damaged repeat of it is known. Nothing tells of a broadcast whether it
// is right, if there is a doubt.
template <typename Scope>
void Receiver::accept(const Frame &frame, uint8_t *packet, const Received &with) {
  const uint16_t age = medium_->begunMillis(with);
  if (frame.destination.kind() == Address::FRAGMENT) {
    if (acceptor_->isOwn(frame)) {
      acceptor_->drop(Counter::RADIO_OWN);
    } else {
      if (fragments_.accept<Scope>(frame, medium_->fragmentLength(), age, doubtful_)) keep();
    }
  } else if (Scope::MANY && doubtful_ && frame.destination.isBroadcast() && !mayBeDoubtful(frame)) {
    acceptor_->drop(Counter::RADIO_DOUBTFUL);
  } else if (acceptor_->isForUs<Scope>(frame)) {
    if (frame.destination.isDevice()) keep();
    if (!acceptor_->accept<Scope>(frame, packet, with.length, age) && frame.destination.isDevice()) forget();
  }
}

template void Receiver::run<WholeScope>();
template void Receiver::run<UnicastScope>();

}  // namespace javinolib
