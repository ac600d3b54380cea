#pragma once

#include <stdint.h>

#include "../framing/Frame.h"
#include "../secure/BoardState.h"
#include "../secure/Envelope.h"
#include "../support/Inlining.h"
#include "Acknowledger.h"
#include "BroadcastMemory.h"
#include "Inbox.h"
#include "../support/Part.h"

namespace javinolib {

/// Decides about whole frames, however they came: drops and counts what is not for this board or not genuine, opens the
/// rest, puts it into the inbox, and answers repeats (SPEC 1, 5, 7).
class FrameAcceptor {
 public:
  FrameAcceptor(BoardState &state, Inbox &inbox, Acknowledger &acknowledger)
      : state_(state), inbox_(inbox), acknowledger_(acknowledger) {}

  Inbox &inbox() { return inbox_; }

  /// Counts what is not taken in.
  /// @return false
  bool drop(Counter why);

  /// Whether the frame is one of our own, or of another board with our address.
  bool isOwn(const Frame &frame) const { return frame.origin == state_->id.address(); }

  /// Whether this is our own address.
  bool isFor(const Address &address) const { return address == state_->id.address(); }

  /// Whether a board of our address accepts the frame; where not, it is counted.
  template <typename Scope = WholeScope>
  bool isForUs(const Frame &frame);

  /// Takes in a frame that is for us.
  /// @param bytes all of it; a sealed one is opened there
  /// @param age how long ago its first packet began, in ms
  /// @return whether it is of no use if it comes again: it is in the inbox, or was before
  template <typename Scope = WholeScope>
  bool accept(const Frame &frame, uint8_t *bytes, Length length, uint16_t age);

  /// Whether a whole frame that is for us comes from where it says: of a broadcast nobody can tell.
  bool isGenuine(const Frame &frame, const uint8_t *bytes, Length length) const;

  /// Looks at the first fragment of a sealed frame for us: without a key, or where its nonce is that of a message that we
  /// have, no other fragment is needed. That is counted, and a repeat of what the host has taken acknowledged again.
  /// @param nonce in the first fragment, 6 bytes
  /// @param wantsAnswer whether the sender awaits one now
  JAVINO_NOINLINE bool needsMore(const Frame &frame, const uint8_t *nonce, bool wantsAnswer);

  /// Tells the sender of a unicast which of its fragments are here. While its key is being renewed it may have used either:
  /// then each is answered.
  void answerFragment(const Frame &frame, const uint8_t *nonce, uint8_t have);

 private:
  template <typename Scope = WholeScope>
  uint8_t slotOf(const Frame &frame, bool other) const;
  bool acceptBroadcast(const Frame &frame, const uint8_t *bytes, Length length, uint16_t age);
  template <typename Scope>
  JAVINO_NOINLINE bool acceptSealed(const Frame &frame, uint8_t *bytes, Length length);
  template <typename Scope>
  bool acceptUnder(uint8_t slot, const Envelope &envelope, const Frame &frame, uint8_t *bytes, Length length);
  bool dropWithoutKey(const Frame &frame);
  bool refuse(ReplayMemory::Verdict verdict, uint8_t slot, const Frame &frame, const uint8_t *nonce);

  Part<BoardState> state_;
  Part<Inbox> inbox_;
  Part<Acknowledger> acknowledger_;
  OwnPart<BroadcastMemory> broadcasts_;
};

}  // namespace javinolib
