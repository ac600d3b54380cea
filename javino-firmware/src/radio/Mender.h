#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../support/Crc16.h"
#include "../support/Inlining.h"
#include "RadioPacket.h"
#if JAVINO_LARGE
#include "ReedSolomon.h"
#endif
#include "../support/Zeroed.h"

namespace javinolib {

/// Makes packets whole that came with wrong bits:
///
/// - A few wrong symbols are mended. Of the symbols nearest to them those are taken with which the CRC is right.
/// - A damaged packet that is like an earlier one is another copy of it, as a sender repeats the same bytes. Both together
///   tell what neither tells alone. One that is like a packet that was right is that packet again.
/// - Parity behind the packet mends what is left (SPEC 6.1).
///
/// It works outside of interrupts, in steps of at most 3 ms. Its memory is bounded. So whoever sends damaged packets costs a
/// board no more than their time on the air allows.
class Mender {
 public:
  enum Progress : uint8_t {
    PENDING,  ///< step() has more to do, or the packet's end is still on the air
    WHOLE,    ///< the packet's bytes are right, as far as CRC and parity tell
    LOST      ///< they cannot be found
  };

  /// Begins with another packet.
  void begin() {
    progress_ = PENDING;
#if JAVINO_LARGE
    phase_ = Phase::LOOKING;
#endif
  }

  /// Does the next part of the work, if any is left.
  Progress step(RadioPacket &packet);

  /// The packet whose bytes cannot be found, or null: some of it may be known beforehand.
  const RadioPacket *lost() const { return progress_ == LOST ? packet_ : nullptr; }

  /// Whether the packet that is whole was damaged.
  bool hasMended() const { return mended_; }

  /// The path of the packet that is whole (SPEC 6).
  uint8_t path() const { return path_; }

  /// The trailer behind the packet that is whole, if it was damaged.
  Trailer trailer() const { return trailer_; }

  /// The trailer behind the last packet of all, as the decoder tells: behind an intact one it is known only later.
  Trailer lastTrailer() const { return lastTrailer_; }
  void setLastTrailer(Trailer trailer) { lastTrailer_ = trailer; }

  /// Whether it may be another than the one that was sent, so that only a tag or a proof can tell. One mended symbol leaves no
  /// doubt.
#if JAVINO_LARGE
  bool isDoubtful() const { return doubtful_; }
#else
  bool isDoubtful() const { return false; }
#endif

  /// Keeps the packet that is whole, as long as there is room: a damaged copy that comes later is taken for it.
  void keep();

  /// The packet that was kept last is a forgery: genuine copies are not to be taken for it.
  void forget();

 private:
  static const uint8_t MOST_CHOICES = 64;  // of symbols that are tried
  static const uint16_t ANY = 0xFFFF;      // nibble
  static const uint8_t MOST_UNDECIDED = 6;

  Progress work(RadioPacket &packet);
  bool note(uint16_t path);

#if JAVINO_LARGE
  enum class Phase : uint8_t { LOOKING, COMPARING, CHOOSING, WRITING, CORRECTING };

  Progress look(RadioPacket &packet);
  Progress compare(RadioPacket &packet);
  Progress choose(uint8_t count);
  Progress choose(RadioPacket &packet);
  Progress write(RadioPacket &packet);
  Progress correct(RadioPacket &packet);
  Progress lose(const RadioPacket &packet);
  bool isLike(const RadioPacket &packet, const RadioPacket &copy);
  bool mayHaveCount(const RadioPacket &packet, uint8_t count) const;
  JAVINO_NOINLINE uint16_t nearest(const RadioPacket &packet, uint8_t index, bool inTrailer, uint8_t &distance) const;
  JAVINO_NOINLINE uint16_t nibblesAt(const RadioPacket &packet, uint8_t index, uint8_t &distance) const;
  uint8_t endOfStep() const;
  void decide(const RadioPacket &packet);
  JAVINO_NOINLINE bool tryChoices();
  static Trailer trailerOf(const RadioPacket &packet, uint8_t count);
  bool findsParity(const RadioPacket &packet);
  void beginParity(RadioPacket &packet);
  void erase(uint8_t byte);
  void save(const RadioPacket &packet);
  const RadioPacket *copy() const { return like_; }

  bool isSaved_ JAVINO_ZEROED;  // the packet's symbols, in the copy that is like it
  Phase phase_ JAVINO_ZEROED;
  uint8_t next_ JAVINO_ZEROED;        // copy to compare, or count to try
  uint8_t at_ JAVINO_ZEROED;          // symbol to decide on, or to write
  uint8_t end_ JAVINO_ZEROED;         // of these
  RadioPacket *like_ JAVINO_ZEROED;   // the copy that is like the packet
  bool isOther_ JAVINO_ZEROED;        // that copy is another fragment, but for its digit and CRC
  uint8_t oldest_ JAVINO_ZEROED;      // copy
  uint8_t distance_ JAVINO_ZEROED;    // of the last undecided symbol from the nearest ones
  uint8_t choices_ JAVINO_ZEROED;     // of the undecided symbols' nibbles, 1…64; 0 for more
  uint8_t undecided_ JAVINO_ZEROED;   // symbols
  Crc16 crc_;                         // of what was decided, with the first nibble of each undecided symbol
  uint8_t places_[MOST_UNDECIDED];    // of the undecided symbols
  uint16_t nibbles_[MOST_UNDECIDED];  // that they may be: bit k for nibble k; in the end one bit each
#if JAVINO_LARGE
  reedsolomon::Decoder parity_;
#endif
  bool doubtful_ JAVINO_ZEROED;
#if JAVINO_LARGE
  RadioPacket copies_[config::DAMAGED_COPIES] JAVINO_ZEROED;
#endif
#endif
  const RadioPacket *packet_ JAVINO_ZEROED;
  Progress progress_ JAVINO_ZEROED;
  Trailer trailer_ JAVINO_ZEROED;
  Trailer lastTrailer_ JAVINO_ZEROED;
  uint8_t path_ JAVINO_ZEROED;
  bool mended_ JAVINO_ZEROED;
};

}  // namespace javinolib
