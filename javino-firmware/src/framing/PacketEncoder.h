#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../support/Inlining.h"

#include "../support/Crc16.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Gives a packet of the serial line, COBS of some bytes and their CRC, one byte at a time and with the closing 0x00
/// (SPEC 4.1). So it can go out as the line takes it: no second buffer is needed, and the CRC is computed while the first
/// bytes are on the line.
class PacketEncoder {
 public:
  /// Begins anew. Each byte must stay as it is until hasGiven() it; the CRC is written behind them.
  JAVINO_OUT_OF_LINE void start(uint8_t *bytes, Length length);

  /// @return whether the closing 0x00 has been given.
  bool done() const { return state_ == DONE; }

  /// Whether the byte in this place is not needed any more.
  bool hasGiven(const uint8_t *place) const { return done() || place < next_; }

  /// The next byte for the line; 0x00 once done.
  uint8_t next();

 private:
  enum State : uint8_t { DONE, BLOCK, DATA, CLOSE };

  uint8_t beginBlock();
  void endBlock();
  void addCrc();

  uint8_t *next_ JAVINO_ZEROED;
  uint8_t *end_ JAVINO_ZEROED;
  Crc16 crc_;
  uint8_t left_ JAVINO_ZEROED;  // data bytes that the current block still lacks
  bool full_ JAVINO_ZEROED;     // the current block has 254 of them: no zero follows it
  bool closed_ JAVINO_ZEROED;   // the CRC stands behind the bytes
  State state_ JAVINO_ZEROED;
};

}  // namespace javinolib
