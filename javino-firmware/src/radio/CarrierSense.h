#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Tells whether another board's carrier is on the air (SPEC 6, 7.4).
///
/// A cheap receiver gives noise where nobody sends, so that edges alone mean nothing. A carrier is taken for one from
/// the twelfth bit of training on: there each edge is two bits behind the last but one, also where two boards train at
/// once, or where the receiver makes its pulses too long. From there a packet's count tells how long it lasts. Where no
/// count is understood after that much training as noise never holds, the carrier may last as long as the longest
/// packet. Ten bits without an edge end it in any case.
///
/// Where a receiver is silent while nobody sends, each pulse as long as a bit tells more: the third one after silence is
/// a carrier. So is a line that stays high for longer than the line code allows: where several begin at once, each fills
/// the others' gaps, and there is neither training nor a rhythm to be heard.
///
/// A packet whose training was not heard, since this board or a third one sent meanwhile, is taken up on its way, after
/// some 30 bits: there too edges are whole bits apart, which noise rarely holds for long.
class CarrierSense {
 public:
  /// @param bitTicks the length of a bit in ticks, 16…13107
  explicit CarrierSense(uint16_t bitTicks);

  /// The line changed outside of a packet, to this level.
  JAVINO_OUT_OF_LINE void addEdge(uint16_t now, bool level);

  /// The line is high for longer than the line code allows; to be said from time to time as long as it is.
  void addHold();

  /// A bit has passed.
  void addBit() {
    if (bitsLeft_ != 0) bitsLeft_--;
  }

  /// A packet has begun, of which so many bits are still to come.
  JAVINO_NOCLONE void expect(uint16_t bits);

  /// That packet is damaged. It goes on where its training was heard too; else it was noise, which now and then has
  /// all that a packet begins with.
  JAVINO_NOCLONE void doubt();

  /// No carrier is heard, as the line has not been listened to.
  JAVINO_NOCLONE void reset();

  /// No carrier is heard, as the line has been at this level for too long.
  void silence(bool level) {
    reset();
    clean_ = !level;
  }

  bool isHeard() const { return bitsLeft_ != 0; }

 private:
  uint8_t wholeBits(uint16_t period) const;
  void addTrainingPeriod();
  void addPeriod();
  void addPulse(uint16_t ticks);
  void expectAtLeast(uint16_t bits);

  const uint16_t bitTicks_;
  uint16_t edge_ JAVINO_ZEROED;        // when the line changed last
  uint16_t edgeBefore_ JAVINO_ZEROED;  // and before that
  uint8_t training_ JAVINO_ZEROED;     // periods of training, one after the other
  uint8_t periods_ JAVINO_ZEROED;      // periods of whole bits, one after the other
  bool trained_ JAVINO_ZEROED;         // the packet that is expected had training
  bool held_ JAVINO_ZEROED;            // a carrier was taken for one since the line stays high
  bool edgeIsOld_ JAVINO_ZEROED;       // it does not tell how long the line has been high
  bool clean_ JAVINO_ZEROED;         // the line was silent, and has had no pulse since that is shorter than half a bit
  uint8_t pulses_ JAVINO_ZEROED;     // since then, or since a packet began
  uint16_t bitsLeft_ JAVINO_ZEROED;  // for which a carrier is expected
};

}  // namespace javinolib
