#pragma once

#include <stdint.h>

#include "../framing/Frame.h"
#include "../support/Inlining.h"
#include "FrameAcceptor.h"
#include "MediumAccess.h"
#include "Retransmitter.h"
#include "Forwarding.h"
#include "CapturedPackets.h"
#include "FragmentReceiver.h"
#include "../support/Zeroed.h"
#include "../support/Part.h"

namespace javinolib {

/// Takes packets from the radio and hands each to the part that it is for (SPEC 1, 4.5). While the host has the radio
/// blocked only acknowledgements of our own messages are looked at.
class Receiver {
 public:
  Receiver(MediumAccess &medium, FrameAcceptor &acceptor, Retransmitter &retransmitter, Acknowledger &acknowledger,
           CapturedPackets &overheard, BoardState &state)
      : medium_(medium),
        acceptor_(acceptor),
        retransmitter_(retransmitter),
        acknowledger_(acknowledger),
        captured_(overheard),
        fragments_(acceptor),
        forwarding_(medium, state.random, state.counters) {}

  /// To be called once, when the radio has begun.
  void begin() { fragments_.begin(medium_); }

  /// Takes in all that the radio holds.
  template <typename Scope = WholeScope>
  void run();

  /// The board's part as a relay.
  BoardsForwarding &forwarding() { return forwarding_; }

  /// Begins to relay, or ends that. Meanwhile the relay's memory is that of one message in fragments.
  void relay(bool on);

  /// Whether the host wants messages; at first it does not.
  void open(bool open);

 private:
  template <typename Scope>
  void accept(uint8_t *packet, const Received &with);
  template <typename Scope>
  void accept(const Frame &frame, uint8_t *packet, const Received &with);
  bool mayBeDoubtful(const Frame &frame) const;
  void keep();
  void forget();

  Part<MediumAccess> medium_;
  Part<FrameAcceptor> acceptor_;
  Part<Retransmitter> retransmitter_;
  Part<Acknowledger> acknowledger_;
  Part<CapturedPackets> captured_;
  bool open_ JAVINO_ZEROED;
  bool doubtful_ JAVINO_ZEROED;  // whether the packet that is looked at is the one sent
  FragmentsTaken<config::LARGE>::Type fragments_;
  BoardsForwarding forwarding_;
};

}  // namespace javinolib
