#pragma once

#include <stdint.h>

namespace javino {

/// Gives the COBS encoding of some bytes, one byte at a time and with the closing 0x00, so that a reply can go out
/// as the line takes it and no second buffer is needed (SPEC 4.1).
class CobsEncoder {
 public:
  CobsEncoder() : next_(0), end_(0), left_(0), full_(false), state_(DONE) {}

  /// Begins anew. The bytes must stay as they are until done().
  void start(const uint8_t *bytes, uint16_t length);

  /// @return whether the closing 0x00 has been given.
  bool done() const { return state_ == DONE; }

  /// The next byte for the line; 0x00 once done.
  uint8_t next();

 private:
  enum State : uint8_t { BLOCK, DATA, CLOSE, DONE };

  uint8_t beginBlock();
  void endBlock();

  const uint8_t *next_;
  const uint8_t *end_;
  uint8_t left_;  // data bytes that the current block still lacks
  bool full_;     // the current block has 254 of them: no zero follows it
  State state_;
};

}  // namespace javino
