#pragma once

#include <stdint.h>

#include "../framing/Frame.h"
#include "../radio/Radio.h"
#include "../secure/ReplayMemory.h"
#include "../storage/KeyStore.h"
#include "../storage/RfId.h"
#include "../support/NoInline.h"
#include "Counters.h"
#include "ReceiveQueue.h"

namespace javino {

/// Takes packets from the radio, drops and counts what is not for this board or not genuine, opens the rest and
/// queues it for the host (SPEC 1, 4.5, 5).
class Receiver {
 public:
  Receiver(Radio &radio, const RfId &id, const KeyStore &keys, ReplayMemory &replays, Counters &counters)
      : radio_(radio), id_(id), keys_(keys), replays_(replays), counters_(counters) {}

  /// Takes in all that the radio holds.
  void run();

  ReceiveQueue &queue() { return queue_; }

 private:
  JAVINO_NOINLINE void accept(uint8_t *packet, uint8_t length);
  bool isForUs(const Frame &frame);
  bool drop(Counter why);
  JAVINO_NOINLINE void acceptSealed(const Frame &frame, uint8_t *packet, uint8_t length);
  JAVINO_NOINLINE void enqueue(const Frame &frame, const uint8_t *content, uint16_t length);

  Radio &radio_;
  const RfId &id_;
  const KeyStore &keys_;
  ReplayMemory &replays_;
  Counters &counters_;
  ReceiveQueue queue_;
};

}  // namespace javino
