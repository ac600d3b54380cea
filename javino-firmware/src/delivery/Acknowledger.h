#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Address.h"
#include "../framing/Limits.h"
#include "../secure/BoardState.h"
#include "../secure/Proof.h"
#include "../support/Inlining.h"
#include "KeyFlags.h"
#include "MediumAccess.h"
#include "../support/Zeroed.h"
#include "../support/Part.h"

namespace javinolib {

/// Sends acknowledgements (SPEC 7.3). They go before all else that the board has to send, even while it waits for one
/// itself: two boards that send to each other would otherwise wait for each other.
///
/// A few wait at a time; when more come the oldest is dropped, as its sender will ask again.
class Acknowledger {
 public:
  Acknowledger(MediumAccess &medium, BoardState &state)
      : medium_(medium), state_(state), end_(entries_), slots_(FRESH_SLOTS), heard_(KeyStore::NO_SLOT) {}

  /// The host has a message.
  /// @param slot the place of the key of the frame that is answered
  /// @param sender its origin
  /// @param nonce its nonce, 6 bytes
  void delivered(uint8_t slot, const Address &sender, const uint8_t *nonce) {
    add(Proof::DELIVERED, slot, sender, nonce, 0);
  }

  /// Answers a fragment.
  /// @param have bit k: fragment k is here
  void fragments(uint8_t slot, const Address &sender, const uint8_t *nonce, uint8_t have) {
    add(Proof::FRAGMENTS, slot, sender, nonce, have);
  }

  /// A frame was refused since it is not above the floor.
  void tellFloor(uint8_t slot, const Address &sender, const uint8_t *nonce) {
    add(Proof::STALE, slot, sender, nonce, 0);
  }

  /// A frame under a key has come. Answers under it do not ask for parity, until its packet is known to have been damaged.
  /// @param slot the place of the key, or NO_SLOT where none is known
  void heard(uint8_t slot) {
    heard_ = slot;
    asking_.set(slot, false);
    added_ = false;
  }

  /// The packet of that frame was damaged, or came again, and its sender understands trailers.
  void askForParity() { asking_.set(heard_, true); }

  /// The packet of that frame was damaged, and its sender does not understand trailers. If its message was delivered before,
  /// that is said twice: the sender is likely to hear as badly, and a firmware that knows no trailers bears little.
  void answerTwice();

  /// Makes the proof of an acknowledgement.
  /// @param slot the place of the key of the frame that is answered
  /// @param proof room for 8 bytes
  /// @return false where the key can no longer be read
  JAVINO_NOINLINE bool prove(uint8_t slot, const Proof::Claim &claim, uint8_t *proof) const;

  /// Counts a packet, of this or of others, that waits for another's carrier to end.
  /// @param deferred whether it was counted, which it is once
  JAVINO_NOINLINE void noteCarrier(bool &deferred);

  /// To be called when keys were deleted: what was to be proved with them is dropped.
  void keysChanged();

  /// Sends what waits, as soon as the air has been quiet for one slot; if it had to wait for the air, for a random number
  /// of slots, since others wait for the end of the same packet.
  JAVINO_NOINLINE void run();

 private:
  static const uint8_t CAPACITY = config::ACKNOWLEDGEMENTS;
  static const uint8_t FRESH_SLOTS = 1;

  struct Entry {
    Proof::Type type;
    bool twice;
    uint8_t slot;
    uint8_t have;
    Address sender;
    uint8_t nonce[NONCE_LENGTH];
  };

  JAVINO_NOINLINE void add(Proof::Type type, uint8_t slot, const Address &sender, const uint8_t *nonce, uint8_t have);
  JAVINO_NOINLINE void remove(Entry *entry);
  void noteBusyAir();
  uint8_t build(const Entry &entry, uint8_t *frame) const;
  void writeBody(const Entry &entry, uint8_t *body) const;

  Part<MediumAccess> medium_;
  Part<BoardState> state_;
  Entry *end_;                   // behind the last one
  uint8_t slots_;                // of quiet air that the first one waits for
  bool deferred_ JAVINO_ZEROED;  // it has been counted as deferred
  bool added_ JAVINO_ZEROED;     // an entry, since then
  uint8_t heard_;                // the place of the key of what came last
  KeyFlags<1> asking_;           // for parity
  Entry entries_[CAPACITY];      // the first is the oldest
};

}  // namespace javinolib
