#pragma once

#include <stdint.h>

#include "LineCode.h"
#include "Radio.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Turns a payload into the bits of a radio packet (SPEC 6), one bit at a time: training, start, count, payload, CRC, and
/// perhaps a trailer.
class RadioEncoder {
 public:
  /// Builds the packet of a payload and starts at its first training bit.
  /// @param length 1…77
  /// @param trailer what follows; on a small board nothing does
  /// @param packet room for the packet, 80 bytes and those of a trailer, lent until the last bit
  /// @param path 0…19 (SPEC 6)
  /// @return false, and nothing changes, where the length is out of range.
  bool start(const uint8_t *payload, uint8_t length, Trailer trailer, uint8_t *packet, uint8_t path = 0);

  /// The bits of a packet without trailer: 84 + 12 n for n bytes of payload.
  static uint16_t bitsOf(uint8_t length) {
    return static_cast<uint16_t>(linecode::BITS_PER_SYMBOL *
                                 (linecode::PREAMBLE_SYMBOLS + 2 * (length + linecode::PACKET_OVERHEAD)));
  }

  /// The bytes of a trailer, each of 12 bits as those of a payload.
  /// @param length of the packet before it, count and CRC included
  static uint8_t trailerLength(Trailer trailer, uint8_t length);

  /// @return whether next() has another bit.
  bool hasNext() const { return bitsLeft_ != 0; }

  /// @return the next bit, true for carrier on; false where hasNext() is false.
  bool next();

 private:
  uint8_t symbolAt(uint8_t index) const;
  static uint8_t addTrailer(Trailer trailer, uint8_t *packet, uint8_t length);

  const uint8_t *packet_ JAVINO_ZEROED;
  uint8_t symbolCount_ JAVINO_ZEROED;
  uint8_t symbolIndex_ JAVINO_ZEROED;  // of the symbol under way
  uint8_t symbol_ JAVINO_ZEROED;       // its bits that are still to go, the next one lowest
  uint8_t bitsLeft_ JAVINO_ZEROED;     // how many of them; 0 only when all is sent
};

}  // namespace javinolib
