#pragma once

#include <stdint.h>

#include "../framing/Frame.h"
#include "../radio/RadioPacket.h"
#include "../secure/BoardState.h"
#include "../secure/Envelope.h"
#include "../secure/Proof.h"
#include "../support/Inlining.h"
#include "../support/Trace.h"
#include "Acknowledger.h"
#include "Backoff.h"
#include "Distances.h"
#include "KeyFlags.h"
#include "MediumAccess.h"
#include "Outbox.h"
#include "Retries.h"
#include "../support/Zeroed.h"
#include "../support/Part.h"

namespace javinolib {

/// Sends the messages of the outbox: seals and cuts each, waits for the air, sends, waits for the acknowledgement of a
/// unicast and tries again, until its outcome is known (SPEC 7).
///
/// Some are under way at once, each to another device, or one of them to many. They take turns: one is on the air, or has
/// its answer awaited, until its attempt has come to nothing. New ones go first. So who is absent holds up nobody else.
class Retransmitter {
 public:
  Retransmitter(MediumAccess &medium, Acknowledger &acknowledger, BoardState &state)
      : medium_(medium), acknowledger_(acknowledger), state_(state) {
    lookAt(messages_[0]);
  }

  /// To be called once, after a boot, when the random numbers are seeded.
  void begin() { nextId_ = static_cast<uint8_t>(state_->random->next(0x3F)); }

  Outbox &outbox() { return outbox_; }

#if JAVINO_LARGE
  /// Its board begins to relay, or ends that: what is sent first tells a distance that is known.
  void relay(const Distances *distances) { distances_ = distances; }
#endif

  /// Whether a message is under way that is sealed with the key in this place.
  bool isUnderWay(uint8_t slot) const;

  /// Does what air and clock allow now.
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE void run();

  /// Takes in a frame to an acknowledgement's address.
  /// @return false where it is not about what is under way
  template <typename Scope = WholeScope>
  bool acknowledged(const Frame &frame);

  /// Another device was acknowledged.
  void otherAcknowledged();

  /// Looks at a unicast from the air: if it is what has its turn, a relay has copied that.
  void copied(const uint8_t *packet, uint8_t length);

  /// Looks at a packet that is damaged beyond mending. An acknowledgement is known beforehand, but for its fragments: so some wrong
  /// bits can be borne.
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE void acknowledged(const RadioPacket &lost);

  /// To be called when keys were deleted: what was sealed with one of them can no longer be acknowledged. A unicast ends.
  template <typename Scope = WholeScope>
  void keysChanged();

 private:
  enum Phase : uint8_t {
    IDLE,        // nothing is under way
    READY,       // its next attempt waits for its turn
    CONTENDING,  // it has its turn: an attempt waits for the air
    PAUSING,     // the next fragment of an attempt waits for a quiet slot
    ON_AIR,      // a packet is being sent
    AWAITING     // an answer is awaited
  };

  // A message that is under way. Slot and nonce of a multicast stay when it has ended, until another message takes its place: a
  // refusal of it may come when all is sent.
  struct Message {
    Phase phase;
    uint8_t number;  // of its transmission
    Retries retries;
    uint8_t count;    // fragments; 1: it travels whole
    uint8_t id;       // where it is in fragments
    uint8_t pending;  // fragments that this attempt still has to send
    uint8_t sent;     // fragments that have been sent at least once; 0: nothing was ever sent from this place
    uint8_t arrived;  // fragments that the receiver has ever had
    bool refused;     // to be sealed anew before its next attempt
    bool resealed;    // or was
    bool trailed;     // a trailer was sent behind it, so that its answer may ask for parity
    uint8_t guesses;  // damaged answers that were not the expected one
    uint32_t sentAt;  // when it was first sent, in ms
    uint8_t slot;     // the place of its key; NO_SLOT for a broadcast, and for a unicast that has ended
    Address destination;
    Address sender;
    uint8_t nonce[NONCE_LENGTH];
  };

  // Flags of a key's partner: whether it has asked for parity in its last answer, or in any; whether it has acknowledged the last
  // message to it.
  enum PartnerFlag : uint8_t { ASKS_PARITY, KNOWS_PARITY, ANSWERS, PARTNER_FLAGS };
  enum Turn : uint8_t { AFTER_ITS_LAST, AFTER_OTHERS, FIRST };

  Message &current() { return config::PARTNERS > 1 ? *current_ : messages_[0]; }
  const Message &current() const { return config::PARTNERS > 1 ? *current_ : messages_[0]; }
  void lookAt(Message &message) {
    if (config::PARTNERS > 1) current_ = &message;
  }
  template <typename Scope>
  bool passes();
  template <typename Scope>
  JAVINO_NOINLINE void nextTurn();
  template <typename Scope>
  bool takeUp();
  Turn turnOf(const Address &destination) const;
  JAVINO_NOINLINE bool seal(bool again);
  template <typename Scope>
  bool mayContend();
  template <typename Scope>
  bool begin(bool again);
  JAVINO_OUT_OF_LINE void restart();
  JAVINO_NOINLINE void contend();
  template <typename Scope>
  JAVINO_NOINLINE void send();
  template <typename Scope>
  void packetSent();
  void await(uint8_t rounds);
  /// Tells a point of the current message; where several are under way, also of which.
  void tellTurn() const {
    if (config::PARTNERS > 1) trace::tell(trace::TURN, current().number);
  }
  void tell(trace::Point point) const {
    tellTurn();
    trace::tell(point);
  }
  void tell(trace::Point point, uint8_t operand) const {
    tellTurn();
    trace::tell(point, operand);
  }
  template <typename Scope>
  void attemptFailed();
  template <typename Scope>
  JAVINO_NOINLINE void finish(Outcome outcome);
  template <typename Scope>
  bool isUnicast() const {
    return !Scope::MANY || isToDevice();
  }
  JAVINO_NOINLINE bool isToDevice() const { return current().destination.isDevice(); }
  ByteQueue::Record frame() const;
  template <typename Scope>
  bool concerns(const Frame &acknowledgement) const;
  template <typename Scope>
  bool accept(const Frame &acknowledgement);
  template <typename Scope>
  bool isExpected(Proof::Type type, const RadioPacket &lost);
  bool isBorne(const Proof::Claim &claim, const RadioPacket &lost) const;
  template <typename Scope>
  Trailer trailer() const;
  bool sendWhole(const ByteQueue::Record &record, Trailer trailer);
  void noteParity(const Proof::Claim &claim);
  bool isProved(const Proof::Claim &claim, const uint8_t *proof) const;
  template <typename Scope>
  bool onAnswer(Proof::Type type, const uint8_t *body);
  template <typename Scope>
  bool onFragments(uint8_t have);
  template <typename Scope>
  bool onStale(const uint8_t *floor, uint16_t uptime);
  bool cannotHaveHadIt(uint16_t uptime) const;

  Part<MediumAccess> medium_;
  Part<Acknowledger> acknowledger_;
  Part<BoardState> state_;

  // These are of the message that has its turn.
  Backoff backoff_;
  uint8_t onAir_;                // the fragment that is being sent
  Patience patience_;            // until its attempt has failed
  bool deferred_ JAVINO_ZEROED;  // this packet has been counted as put off

#if JAVINO_LARGE
  const Distances *distances_ JAVINO_ZEROED;
#endif
  KeyFlags<PARTNER_FLAGS> partners_;
  uint8_t nextId_ JAVINO_ZEROED;
  uint8_t turn_ JAVINO_ZEROED;  // the place that has its turn
  Message
      *current_;  // the message there, or one that is looked at; not used where there is only one, which AVR reaches
                  // in one instruction
  Message messages_[config::PARTNERS] JAVINO_ZEROED;
  Outbox outbox_;
};

}  // namespace javinolib
