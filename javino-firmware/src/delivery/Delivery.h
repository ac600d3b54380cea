#pragma once

#include <stdint.h>

#include "../radio/Radio.h"
#include "../secure/NonceSource.h"
#include "../secure/ReplayMemory.h"
#include "../storage/BootEpoch.h"
#include "../storage/KeyStore.h"
#include "../storage/RfId.h"
#include "../support/Random.h"
#include "Acknowledger.h"
#include "Admission.h"
#include "MediumAccess.h"
#include "Courier.h"
#include "Inbox.h"
#include "Pieces.h"
#include "Receiver.h"

namespace javino {

/// Everything between the air and the host's requests: what is to be sent and what was received (SPEC 7).
///
/// Nothing waits: run() does what air and clock allow at the moment, and is to be called whenever the CPU has woken up.
/// While only time has to pass there is nothing to do; the interrupt of the core's timer, once a millisecond, ends the
/// CPU's sleep soon enough.
class Delivery {
 public:
  Delivery(Radio &radio, const RfId &id, const BootEpoch &epoch, const KeyStore &keys, ReplayMemory &replays,
           NonceSource &nonces, Counters &counters)
      : id_(id),
        epoch_(epoch),
        keys_(keys),
        medium_(radio),
        acknowledger_(medium_, id, keys, replays, random_, counters),
        inbox_(replays, acknowledger_),
        admission_(id, keys, replays, inbox_, acknowledger_, counters),
        courier_(medium_, keys, nonces, random_, counters),
        receiver_(radio, medium_, id, admission_, courier_, counters) {}

  /// To be called once, after a boot, when id and epoch are known and the radio has begun.
  void begin();

  void run();

  /// To be called when the RF id has changed: random numbers begin from it.
  void seed() { random_.seed(id_.address().value(), epoch_.value()); }

  /// To be called when keys may have been deleted.
  void keysChanged();

  /// Opens or blocks the radio for messages (SPEC 4.3).
  void open(bool open) { receiver_.open(open); }

  /// Whether another board's carrier is heard, or something is to be sent: the host may soon have something to be told.
  bool isActive() const { return medium_.hearsCarrier() || courier_.isBusy(); }

  /// The place of the key that the message under way is sealed with, or NO_SLOT.
  uint8_t underWay() const { return courier_.underWay(); }

  /// Whether a frame of this length fits the radio's packets.
  bool carries(uint16_t frameLength) const { return pieces::count(frameLength, medium_.pieceLength()) <= MAX_PIECES; }

  Outbox &outbox() { return courier_.outbox(); }
  Inbox &inbox() { return inbox_; }

 private:
  const RfId &id_;
  const BootEpoch &epoch_;
  const KeyStore &keys_;
  Random random_;
  MediumAccess medium_;
  Acknowledger acknowledger_;
  Inbox inbox_;
  Admission admission_;
  Courier courier_;
  Receiver receiver_;
};

}  // namespace javino
