#pragma once

#include <stdint.h>

#include "../support/Counters.h"
#include "../framing/Frame.h"
#include "../radio/Radio.h"
#include "../support/Inlining.h"
#include "Admission.h"
#include "MediumAccess.h"
#include "Courier.h"
#include "PieceReceiver.h"

namespace javino {

/// Takes packets from the radio and hands each to the part that it is for (SPEC 1, 4.5). While the host has the radio
/// blocked only acknowledgements of our own messages are looked at.
class Receiver {
 public:
  Receiver(Radio &radio, const MediumAccess &medium, const RfId &id, Admission &admission, Courier &courier,
           Counters &counters)
      : radio_(radio),
        medium_(medium),
        id_(id),
        admission_(admission),
        courier_(courier),
        counters_(counters),
        pieces_(admission, counters),
        open_(false) {}

  /// Takes in all that the radio holds.
  void run();

  /// Whether the host wants messages; at first it does not.
  void open(bool open);

 private:
  JAVINO_NOINLINE void accept(uint8_t *packet, uint8_t length);
  void accept(const Frame &frame, uint8_t *packet, uint8_t length);

  Radio &radio_;
  const MediumAccess &medium_;
  const RfId &id_;
  Admission &admission_;
  Courier &courier_;
  Counters &counters_;
  PiecesTaken<config::REASSEMBLIES != 0>::Type pieces_;
  bool open_;
};

}  // namespace javino
