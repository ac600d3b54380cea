#pragma once

#include <stdint.h>

#include "../framing/Frame.h"
#include "../support/Inlining.h"
#include "Admission.h"
#include "MediumAccess.h"
#include "Courier.h"
#include "Forwarding.h"
#include "Overheard.h"
#include "PieceReceiver.h"
#include "../support/Zeroed.h"
#include "../support/Part.h"

namespace javinolib {

/// Takes packets from the radio and hands each to the part that it is for (SPEC 1, 4.5). While the host has the radio
/// blocked only acknowledgements of our own messages are looked at.
class Receiver {
 public:
  Receiver(MediumAccess &medium, Admission &admission, Courier &courier, Acknowledger &acknowledger,
           Overheard &overheard, BoardState &state)
      : medium_(medium),
        admission_(admission),
        courier_(courier),
        acknowledger_(acknowledger),
        overheard_(overheard),
        pieces_(admission),
        forwarding_(medium, state.random, state.counters) {}

  /// Takes in all that the radio holds.
  template <typename Scope = WholeScope>
  void run();

  /// The board's part as a relay.
  BoardsForwarding &forwarding() { return forwarding_; }

  /// Begins to relay, or ends that. Meanwhile the relay's memory is that of one message in pieces.
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
  Part<Admission> admission_;
  Part<Courier> courier_;
  Part<Acknowledger> acknowledger_;
  Part<Overheard> overheard_;
  bool open_ JAVINO_ZEROED;
  bool doubtful_ JAVINO_ZEROED;  // whether the packet that is looked at is the one sent
  PiecesTaken<config::LARGE>::Type pieces_;
  BoardsForwarding forwarding_;
};

}  // namespace javinolib
