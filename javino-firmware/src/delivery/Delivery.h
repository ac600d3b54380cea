#pragma once

#include <stdint.h>

#include "../radio/Radio.h"
#include "../secure/BoardState.h"
#include "../support/Inlining.h"
#include "Acknowledger.h"
#include "FrameAcceptor.h"
#include "MediumAccess.h"
#include "CapturedPackets.h"
#include "Retransmitter.h"
#include "Forwarding.h"
#include "Inbox.h"
#include "Fragments.h"
#include "Receiver.h"
#include "../support/Part.h"

namespace javinolib {

/// Everything between the air and the host's requests: what is to be sent and what was received (SPEC 7).
///
/// Nothing waits: run() does what air and clock allow at the moment, and is to be called whenever the CPU has woken up.
/// While only time has to pass there is nothing to do; the interrupt of the core's timer, once a millisecond, ends the
/// CPU's sleep soon enough.
class Delivery {
 public:
  Delivery(Radio &radio, BoardState &state)
      : state_(state),
        medium_(radio),
        acknowledger_(medium_, state),
        inbox_(state.replays, acknowledger_),
        acceptor_(state, inbox_, acknowledger_),
        retransmitter_(medium_, acknowledger_, state),
        captured_(state.counters),
        receiver_(medium_, acceptor_, retransmitter_, acknowledger_, captured_, state) {}

  /// Starts the radio; to be called once, after a boot, when id and epoch are known.
  /// @return false where it does not start
  bool begin();

  template <typename Scope = WholeScope>
  void run();

  /// Whether the radio holds nothing for run(). Safe to call with interrupts off.
  bool isIdle() const { return medium_->isIdle(); }

  /// Copies the radio's counters.
  void radioCounters(RadioCounters &into) const { medium_->counters(into); }

  /// To be called when the RF id has changed: random numbers begin from it.
  void seed();

  /// To be called when keys may have been deleted.
  template <typename Scope = WholeScope>
  void keysChanged();

  /// Opens or blocks the radio for messages (SPEC 4.3).
  void open(bool open) { receiver_.open(open); }

  /// Whether a message is under way that is sealed with the key in this place.
  bool isUnderWay(uint8_t slot) const { return retransmitter_->isUnderWay(slot); }

  /// Whether a frame of this length fits the radio's packets.
  bool carries(Length frameLength) const {
    return fragments::count(frameLength, medium_->fragmentLength()) <= MAX_FRAGMENTS;
  }

  /// The most bytes of a frame that travels in one packet, beside its header.
  uint8_t fragmentLength() const { return medium_->fragmentLength(); }

  /// Whether the board can be a relay.
  bool canRelay() { return config::LARGE && medium_->canRelay(); }

  /// Makes the board a relay, or none, and stores that (SPEC 4.3, relaying).
  /// @param number RELAYING_LENGTH bytes, by which it waits differently from another relay without RF id; none to end it
  /// @return false where the EEPROM did not keep it
  bool relay(const uint8_t *number);

  bool relays() { return receiver_.forwarding().isOn(); }

  Outbox &outbox() { return retransmitter_->outbox(); }
  Inbox &inbox() { return inbox_; }
  CapturedPackets &overheard() { return captured_; }

 private:
  void beginToRelay(const uint8_t *number);

  Part<BoardState> state_;
  OwnPart<MediumAccess> medium_;
  OwnPart<Acknowledger> acknowledger_;
  OwnPart<Inbox> inbox_;
  OwnPart<FrameAcceptor> acceptor_;
  OwnPart<Retransmitter> retransmitter_;
  OwnPart<CapturedPackets> captured_;
  Receiver receiver_;
};

}  // namespace javinolib
