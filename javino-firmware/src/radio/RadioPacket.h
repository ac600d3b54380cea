#pragma once

#include <stdint.h>

#include "LineCode.h"
#include "Radio.h"

namespace javino {

/// A packet as it came from the air (SPEC 6), whose CRC nobody has looked at yet.
///
/// A wrong bit makes a symbol of three ones one of two or four, which is in no table: so it is known where the bit is,
/// and the CRC tells which of the symbols around it was sent. Both are done outside of interrupts, as they take up to
/// 24 000 cycles for the longest packet.
struct RadioPacket {
  static const uint8_t NO_NIBBLE = 0xFF;

  uint8_t bytes[MAX_RADIO_PAYLOAD + linecode::PACKET_OVERHEAD];  ///< count (4…80), payload, CRC
  uint8_t wrongNibble;  ///< of the bytes, high nibbles first; NO_NIBBLE where each symbol was in the table
  uint8_t wrongSymbol;  ///< what came in its place

  uint8_t *payload() { return bytes + 1; }
  const uint8_t *payload() const { return bytes + 1; }

  /// @return 1…77.
  uint8_t payloadLength() const { return static_cast<uint8_t>(bytes[0] - linecode::PACKET_OVERHEAD); }

  /// @return whether the CRC is right.
  bool isIntact() const;

  /// Puts in the one symbol at a distance of one bit from the wrong one with which the CRC is right.
  /// @return false where there is no such symbol, or where there are several.
  bool mend();

 private:
  void setWrongNibble(uint8_t nibble);
};

}  // namespace javino
