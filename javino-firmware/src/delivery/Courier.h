#pragma once

#include <stdint.h>

#include "../framing/Frame.h"
#include "../secure/BoardState.h"
#include "../secure/Envelope.h"
#include "../secure/Proof.h"
#include "../support/Inlining.h"
#include "Backoff.h"
#include "MediumAccess.h"
#include "Outbox.h"
#include "../support/Zeroed.h"

namespace javino {

/// Sends the messages of the outbox, one at a time: seals and cuts each, waits for the air, sends, waits for the
/// acknowledgement of a unicast and tries again, until its outcome is known (SPEC 7).
class Courier {
 public:
  Courier(MediumAccess &medium, BoardState &state) : medium_(medium), state_(state), slot_(KeyStore::NO_SLOT) {}

  /// To be called once, after a boot, when the random numbers are seeded.
  void begin() { nextId_ = static_cast<uint8_t>(state_.random.next(0x3F)); }

  Outbox &outbox() { return outbox_; }

  /// Whether a message is under way or waits.

  /// The place of the key that the message under way is sealed with, or NO_SLOT.
  uint8_t underWay() const { return phase_ == IDLE ? KeyStore::NO_SLOT : slot_; }

  /// Does what air and clock allow now.
  JAVINO_NOINLINE void run();

  /// Takes in a frame to an acknowledgement's address.
  /// @return false where it is not about what is under way
  JAVINO_NOINLINE bool acknowledged(const Frame &frame);

  /// To be called when keys were deleted: what was sealed with one of them can no longer be acknowledged.
  void keysChanged();

 private:
  enum Phase : uint8_t {
    IDLE,        // nothing is under way
    CONTENDING,  // an attempt waits for its turn
    PAUSING,     // the next piece of an attempt waits for a quiet slot
    ON_AIR,      // a packet is being sent
    AWAITING     // an answer is awaited
  };

  void takeUpNext();
  JAVINO_NOINLINE bool seal(bool again);
  void restart();
  JAVINO_NOINLINE void contend(uint8_t pending);
  void noteCarrier();
  JAVINO_NOINLINE void send();
  void packetSent();
  void attemptFailed();
  JAVINO_NOINLINE void finish(Outcome outcome);
  bool isUnicast() const { return destination_.isDevice(); }
  bool concerns(const Frame &acknowledgement) const;
  JAVINO_NOINLINE bool isProved(const Proof::Claim &claim, const uint8_t *proof) const;
  bool onAnswer(Proof::Type type, const uint8_t *body);
  bool onPieces(uint8_t have);
  bool onStale(const uint8_t *floor, uint16_t uptime);
  bool cannotHaveHadIt(uint16_t uptime) const;

  MediumAccess &medium_;
  BoardState &state_;
  Backoff backoff_;

  Phase phase_ JAVINO_ZEROED;
  uint8_t attempt_;    // attempts in a row that came to nothing
  uint8_t sendsLeft_;  // of a broadcast or multicast
  uint8_t count_;      // pieces of this message; 1: it travels whole
  uint8_t id_;         // of this message, where it is in pieces
  uint8_t pending_;    // pieces that this attempt still has to send
  uint8_t onAir_;      // the one of them that is being sent
  uint8_t sent_;       // pieces that have been sent at least once
  uint8_t arrived_;    // pieces that the receiver has ever had
  uint8_t patience_;   // quiet milliseconds that are left until the next attempt
  bool resealed_;
  bool deferred_ JAVINO_ZEROED;  // this packet has been counted as put off
  uint32_t sentAt_;              // when this message was first sent, in ms

  // What is under way, or was last: a stale notice for a multicast may come when all is sent.
  uint8_t slot_;  // the place of its key; NO_SLOT for a broadcast, and for a unicast that has ended
  Address destination_;
  Address sender_;
  uint8_t nonce_[NONCE_LENGTH];

  uint8_t nextId_ JAVINO_ZEROED;
  Outbox outbox_;
};

}  // namespace javino
