#pragma once

#include <stdint.h>

#include "../framing/Frame.h"
#include "../support/Inlining.h"
#include "FrameAcceptor.h"
#include "IgnoredMessages.h"
#include "MediumAccess.h"
#include "Reassembly.h"
#include "../support/Part.h"

namespace javinolib {

/// Puts fragments together, answers those that want an answer, and hands whole frames on (SPEC 7.1, 7.3).
class FragmentReceiver {
 public:
  explicit FragmentReceiver(FrameAcceptor &acceptor) : acceptor_(acceptor), reassembly_(acceptor.inbox()) {}

  /// To be called once, when the radio has begun.
  void begin(const MediumAccess &medium);

  /// Takes in a frame to a fragment's address, from another board.
  /// @param longest the most bytes of a fragment, 16…67
  /// @param age how long ago its packet began, in ms
  /// @param isDoubtful whether only a tag can tell if it is right: then it must be of a sealed frame
  /// @return whether it is of use
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE bool accept(const Frame &fragment, uint8_t longest, uint16_t age, bool isDoubtful);

  /// Forgets what has got no new fragment for long; to be called often.
  void run();

  /// Forgets all that is half received.
  void clear() { reassembly_.clear(); }

  /// Puts together one message less at a time, as a relay needs its place (Reassembly).
  BoardsForwarding::Memory *lend() { return reassembly_.lend(); }
  void takeBack() { reassembly_.takeBack(); }

 private:
  static bool startsFrame(const Frame &fragment, uint8_t longest, Frame &whole);
  template <typename Scope>
  bool isWanted(const Frame &fragment, uint8_t id, const Frame &whole, bool wantsAnswer, uint16_t now);
  bool isSealed(const Frame &fragment, uint8_t id, uint8_t index);
  PartialFrame *placeFor(const Address &origin, uint8_t id, uint8_t longest, bool isFirst, uint16_t begun);
  JAVINO_NOINLINE void finish(PartialFrame &partial, uint16_t now);
  static void answer(FrameAcceptor &acceptor, const PartialFrame &partial);

  Part<FrameAcceptor> acceptor_;
  IgnoredMessages ignored_;
  Reassembly reassembly_;
  uint16_t expiryMillis_;  // set by begin()
};

/// The substitute for it on a board that has no room for fragments (Config.h): drops them.
class NoFragmentReceiver {
 public:
  explicit NoFragmentReceiver(FrameAcceptor &acceptor) : acceptor_(acceptor) {}

  template <typename Scope = WholeScope>
  bool accept(const Frame &, uint8_t, uint32_t, bool) {
    return acceptor_->drop(Counter::RADIO_FRAGMENTS_DROPPED);
  }
  void begin(const MediumAccess &) {}
  void run() {}
  void clear() {}
  BoardsForwarding::Memory *lend() { return nullptr; }
  void takeBack() {}

 private:
  Part<FrameAcceptor> acceptor_;
};

/// Which of the two a board has. (Arduino's compiler brings no <type_traits>.)
template <bool taken>
struct FragmentsTaken {
  typedef FragmentReceiver Type;
};
template <>
struct FragmentsTaken<false> {
  typedef NoFragmentReceiver Type;
};

}  // namespace javinolib
