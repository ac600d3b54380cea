#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../addressing/Address.h"
#include "../framing/Limits.h"
#include "../support/NoInline.h"

namespace javino {

/// A message of which pieces have come, in any order (SPEC 7.1).
struct PartialFrame {
  uint8_t have;      ///< bit k: piece k is here; 0: this place is free
  uint8_t id;        ///< 0…63
  Address origin;
  uint16_t length;   ///< of the whole frame; 0 while neither the first piece nor a short one, the last, has come
  uint16_t lastNew;  ///< when the last new piece came, in ms
  uint32_t begun;    ///< when the piece that came first began, in ms
  uint8_t bytes[MAX_FRAME_LENGTH];

  bool isFree() const { return have == 0; }

  /// Whether the first piece is here, and with it the frame's header.
  bool hasFirst() const { return (have & 1) != 0; }

  /// Whether all pieces are here.
  bool isWhole() const;

  /// Takes in a piece.
  /// @param index 0…7
  /// @param frameLength the whole frame's, where this piece tells it; else 0
  /// @return false, and nothing changes, where it does not fit what is known.
  bool add(uint8_t index, const uint8_t *piece, uint8_t pieceLength, uint16_t frameLength, uint16_t now);

 private:
  bool fitsWhole(uint8_t index, uint8_t pieceLength, uint16_t frameLength) const;
};

/// The messages that are being put together: a fixed number (Config.h), so that senders who never end theirs take no
/// more than that, and for no longer than 5 s.
class Reassembly {
 public:
  Reassembly();

  /// @return the message of this origin and id, or null.
  JAVINO_NOINLINE PartialFrame *find(const Address &origin, uint8_t id);

  /// Begins a message. One whose first piece is here takes the place of one without, if no other is free, since that
  /// is perhaps for others.
  /// @param hasFirst whether its first piece is what came
  /// @param expired set where another message was forgotten for it
  /// @return null where no place is free
  PartialFrame *begin(const Address &origin, uint8_t id, bool hasFirst, bool &expired);

  /// Forgets what has got no new piece for 5 s.
  /// @return how many messages that were
  uint8_t expire(uint16_t now);

  /// Forgets all.
  void clear();

 private:
  PartialFrame frames_[config::REASSEMBLIES];
};

}  // namespace javino
