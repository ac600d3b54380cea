#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Address.h"
#include "../framing/Limits.h"
#include "../support/Inlining.h"
#include "Forwarding.h"
#include "Inbox.h"
#include "Fragments.h"
#include "../support/Part.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// A message of which fragments have come, in any order (SPEC 7.1).
///
/// Nothing in a fragment proves that it is genuine, only the tag of the whole does. So a fragment that is forged must not shut
/// out the one that it stands for: where two different ones came, both are kept, and the tag tells which is right. The
/// length is that which a first fragment says, and no other fragment's.
class PartialFrame {
 public:
  uint8_t id;  ///< 0…63
  Address origin;
  uint16_t lastNew;  ///< when the last new fragment came, in ms
  uint16_t begun;    ///< when the fragment that came first began, in ms

  /// Room for the frame, or null.
  const uint8_t *bytes() const { return bytes_; }
  uint8_t *bytes() { return bytes_; }
  void setBytes(uint8_t *bytes) { bytes_ = bytes; }

  bool isFree() const { return have_ == 0; }

  void clear() { have_ = 0; }

  /// Begins with nothing of a message, where there is room.
  /// @param longest the most bytes of a fragment, 16…67
  void begin(const Address &from, uint8_t number, uint8_t longest);

  /// Whether a first fragment is here, and with it a frame's header.
  bool hasFirst() const { return (have_ & 1) != 0; }

  /// The fragments that are here, and fit the first one: bit k for fragment k.
  uint8_t have() const;

  /// The same without a fragment that is to be sent once more.
  uint8_t undoubted() const { return static_cast<uint8_t>(have() & ~doubted_); }

  /// Whether all fragments are here.
  bool isWhole() const;

  /// The whole frame's length, as the first fragment says.
  uint16_t length() const;

  /// Takes in a fragment. Of two different ones the newer counts, and the older is kept aside in place of one that was there.
  /// @param index 0…7; a first fragment is one that begins a frame
  /// @return false, and nothing changes, where it does not fit any first fragment that is here, or would not fit a frame.
  JAVINO_NOINLINE bool add(uint8_t index, const uint8_t *fragment, uint8_t fragmentLength, uint16_t now);

  /// Sets another choice of the fragments of which there are two. After CHOICES calls all choices were there, and the newest
  /// fragments count again.
  /// @param turn 0…3
  /// @return whether that changed anything
  bool choose(uint8_t turn);
  static const uint8_t CHOICES = 4;

  /// No choice is genuine. The newer of two first fragments is forgotten, or the fragment that came last where it has replaced
  /// another, which counts again; else it is to be sent once more, and the fourth time all is forgotten, as another one must be wrong.
  void refuse();

 private:
  // The other one of two fragments.
  struct Aside {
    uint8_t index;
    uint8_t length;  // 0: none
    uint8_t bytes[FRAGMENT_LENGTH];
  };

  bool isFragmentOf(uint16_t frameLength, uint8_t index, uint8_t fragmentLength) const;
  bool fits(uint8_t index, uint8_t fragmentLength) const;
  uint8_t *at(uint8_t index) { return bytes_ + index * longest_; }
  // No array is indexed, since gcc multiplies to do so: 68 bytes of flash less.
  Aside &asideOf(uint8_t index) { return index == 0 ? aside_[0] : aside_[1]; }
  JAVINO_NOINLINE bool swap(Aside &aside);

  uint8_t have_ JAVINO_ZEROED;  // bit k: fragment k is here; 0: this place is free
  uint8_t last_;                // the fragment that came last
  uint8_t refusals_;
  uint8_t longest_;
  uint8_t doubted_;  // bit k: fragment k is here, but is to be sent once more
  uint8_t lengths_[MAX_FRAGMENTS];
  uint8_t *bytes_ JAVINO_ZEROED;
  // Last: AVR reaches only the first 64 bytes of an object in one instruction.
  Aside aside_[2];  // of the first fragment, and of any other
};

/// The messages that are being put together: two, so that senders who never end theirs take no more than that, and for no
/// longer than FragmentReceiver waits. One of them lies in the inbox, as long as that is nearly empty.
class Reassembly {
 public:
  explicit Reassembly(Inbox &inbox) : inbox_(inbox) {}

  /// @return the message of this origin and id, or null.
  JAVINO_NOINLINE PartialFrame *find(const Address &origin, uint8_t id);

  /// Begins a message. One whose first fragment is here takes the place of one without, if no other is free, since that
  /// is perhaps for others.
  /// @param hasFirst whether its first fragment is what came
  /// @param expired set where another message was forgotten for it
  /// @return null where no place is free
  PartialFrame *begin(const Address &origin, uint8_t id, uint8_t longest, bool hasFirst, bool &expired);

  /// Forgets a message: there is room for it in the inbox then, if there is any.
  /// @return where its bytes are until anything else comes
  uint8_t *release(PartialFrame &frame);

  /// Forgets what has got no new fragment for so many ms, at most 60 000.
  /// @return how many messages that were
  uint8_t expire(uint16_t now, uint16_t after);

  /// Forgets all.
  void clear();

  /// Has the place in the inbox only until takeBack(), and forgets what is in the other one.
  /// @return its memory, cleared
  BoardsForwarding::Memory *lend();
  void takeBack() { lent_ = false; }

 private:
  static const uint8_t PLACES = 2;

  // The memory of a message, or of a relay.
  union Room {
    uint8_t frame[MAX_FRAME_LENGTH];
    BoardsForwarding::Memory relay;
  };

  PartialFrame *end() { return frames_ + PLACES; }
  PartialFrame &inRoom() { return frames_[0].bytes() == room_.frame ? frames_[0] : frames_[1]; }
  bool findRoom(PartialFrame &frame);

  Part<Inbox> inbox_;
  bool lent_ JAVINO_ZEROED;
  PartialFrame frames_[PLACES] JAVINO_ZEROED;
  Room room_ JAVINO_ZEROED;
};

}  // namespace javinolib
