#pragma once

#include <stdint.h>

#include "CarrierSense.h"
#include "../support/Inlining.h"
#include "Radio.h"
#include "RadioQueue.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Finds radio packets (SPEC 6) in a stream of bits and queues them as they came, right or wrong.
///
/// A packet begins where at most 3 of the last 36 bits differ from training and start symbol: noise does that once in 73
/// minutes (2000 bit/s); or where the last 24 are right, since a receiver may have missed the first ones. What follows is
/// given up when it looks like noise: when eight symbols more were impossible than possible. Meanwhile the search goes on,
/// and another start takes the packet's place where that looks like noise.
class RadioDecoder {
 public:
  /// @param bitTicks the length of a bit in ticks, 16…13107
  explicit RadioDecoder(uint16_t bitTicks);

  /// Takes the next bit from the air.
  JAVINO_OUT_OF_LINE void add(bool bit);

  /// @return whether a packet is under way whose count has come, or its parity.
  bool inPacket() const { return phase_ >= BODY; }

  /// The line has been silent for longer than the line code allows: a packet under way has ended, or is damaged.
  void endOfSignal();

  /// Forgets all bits; a packet under way counts as missed, since it is the receiver that leaves it.
  void abandon();

  /// The trailer behind the last packet.
  Trailer trailer() const { return trailer_; }

  CarrierSense &carrier() { return carrier_; }
  const CarrierSense &carrier() const { return carrier_; }
  RadioCounters &counters() { return counters_; }
  const RadioCounters &counters() const { return counters_; }
  RadioQueue &queue() { return queue_; }
  const RadioQueue &queue() const { return queue_; }

 private:
  enum Phase : uint8_t {
    HUNTING,  // for a start
    TRAILER,  // the word behind a packet, that says whether parity follows
    COUNT,    // the first two symbols
    BODY,     // the others
    PARITY    // what follows the word
  };

  JAVINO_NOINLINE bool isStart();
  bool isBetterStart(uint8_t wrong) const;
  void begin(uint8_t wrong);
  JAVINO_NOCLONE void addSymbol();
  JAVINO_OUT_OF_LINE void store();
  JAVINO_NOCLONE void startBody();
  void endBody();
  void addToTrailer();
  void refuse();
  void giveUp();
  void close();
  void hunt() { phase_ = HUNTING; }

  uint16_t bits_ JAVINO_ZEROED;         // the last twelve, the newest at the top
  uint16_t newTraining_ JAVINO_ZEROED;  // the twelve before those
  uint16_t oldTraining_ JAVINO_ZEROED;  // and before those
  Phase phase_ JAVINO_ZEROED;
  uint8_t startErrors_ JAVINO_ZEROED;  // wrong bits of the start of the packet under way
  int8_t noise_ JAVINO_ZEROED;         // impossible symbols less the possible ones, at least LEAST_NOISE
  uint8_t symbolBits_ JAVINO_ZEROED;   // bits of the symbol under way
  uint8_t symbols_ JAVINO_ZEROED;      // that have come
  uint8_t end_ JAVINO_ZEROED;          // how many are to come in all
  bool counted_ JAVINO_ZEROED;         // both symbols of the count are in the table
  volatile Trailer trailer_ JAVINO_ZEROED;
  RadioPacket *packet_ JAVINO_ZEROED;  // where all goes; null where no slot was free
  uint8_t *next_ JAVINO_ZEROED;        // in it, where the next byte goes
  CarrierSense carrier_;
  RadioCounters counters_ JAVINO_ZEROED;
  RadioQueue queue_;  // last: AVR reaches only the first 64 bytes of an object in one instruction
};

}  // namespace javinolib
