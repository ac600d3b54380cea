#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javino {

/// Tells whether another board's carrier is on the air (SPEC 6, 7.4).
///
/// A cheap receiver gives noise where nobody sends, so that edges alone mean nothing. A carrier is taken for one from
/// the twelfth bit of training on: there each edge is two bits behind the last but one, also where two boards train at
/// once, or where the receiver makes its pulses too long. From there a packet's count tells how long it lasts. Where no
/// count is understood after that much training as noise never holds, the carrier may last as long as the longest
/// packet. Ten bits without an edge end it in any case.
///
/// A packet whose training was not heard, since this board or a third one sent meanwhile, is taken up on its way, after
/// some 30 bits: there too edges are whole bits apart, which noise rarely holds for long.
class CarrierSense {
 public:
  /// @param bitTicks the length of a bit in ticks, 16…13107
  explicit CarrierSense(uint16_t bitTicks);

  /// The line changed outside of a packet.
  JAVINO_OUT_OF_LINE void addEdge(uint16_t now);

  /// A bit has passed.
  void addBit() {
    if (bitsLeft_ != 0) bitsLeft_--;
  }

  /// A packet has begun, of which so many bits are still to come.
  void expect(uint16_t bits);

  /// That packet is damaged. It goes on where its training was heard too; else it was noise, which now and then has
  /// all that a packet begins with.
  void doubt();

  /// The line has been silent, or not listened to: no carrier is heard.
  void reset();

  bool isHeard() const { return bitsLeft_ != 0; }

 private:
  uint8_t wholeBits(uint16_t period) const;
  void addTrainingPeriod();
  void addPeriod();
  void expectAtLeast(uint16_t bits);

  const uint16_t bitTicks_;
  const uint16_t toleranceTicks_;      // of a period, either way
  uint16_t edge_ JAVINO_ZEROED;        // when the line changed last
  uint16_t edgeBefore_ JAVINO_ZEROED;  // and before that
  uint8_t training_ JAVINO_ZEROED;     // periods of training, one after the other
  uint8_t periods_ JAVINO_ZEROED;      // periods of whole bits, one after the other
  bool trained_ JAVINO_ZEROED;         // the packet that is expected had training
  uint16_t bitsLeft_ JAVINO_ZEROED;    // for which a carrier is expected
};

}  // namespace javino
