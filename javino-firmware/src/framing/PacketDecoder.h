#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "Limits.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// The outcome of a byte from the serial line (SPEC 4.1).
enum class PacketEvent : uint8_t {
  NONE,       ///< the packet goes on, or was empty
  PACKET,     ///< a whole packet is there, its CRC right
  BAD_COBS,   ///< refused: it ended within a COBS block
  TOO_LONG,   ///< refused: more bytes than there is room for; TOO_SHORT where a small board has room for 255
  TOO_SHORT,  ///< refused: fewer than 13 bytes
  BAD_CRC     ///< refused: the CRC is not that of its bytes
};

/// Finds packets in the bytes of the serial line, one byte at a time, in a buffer of its user (SPEC 4.1).
/// After any damage the next packet begins behind the next 0x00.
class PacketDecoder {
 public:
  /// @param room the most bytes of a packet, MIN_PACKET_LENGTH…MAX_PACKET_LENGTH
  PacketDecoder(uint8_t *bytes, Length room) : bytes_(bytes), end_(bytes + room), next_(bytes) {}

  /// Takes the next byte. After PACKET the accessors below hold until the next call.
  PacketEvent add(uint8_t byte);

  /// The place of the next byte.
  const uint8_t *next() const { return next_; }

  uint8_t sequence() const { return bytes_[0]; }
  const uint8_t *frame() const { return bytes_ + 1; }
  Length frameLength() const { return static_cast<Length>(length_ - 3); }

  /// The packet's CRC as it came.
  JAVINO_NOINLINE uint16_t crc() const;

 private:
  void beginBlock(uint8_t code);
  JAVINO_NOINLINE void append(uint8_t byte);
  PacketEvent finish();
  PacketEvent check(bool inBlock) const;

  uint8_t *const bytes_;
  const uint8_t *const end_;
  uint8_t *next_;                // beyond the room by one where more bytes came than fit
  Length length_ JAVINO_ZEROED;  // of the packet that has ended last
  uint8_t left_ JAVINO_ZEROED;   // bytes that the current COBS block still lacks
  bool zeroOwed_ JAVINO_ZEROED;  // a zero belongs behind the block, if another block follows
  bool started_ JAVINO_ZEROED;   // a byte other than 0x00 has come
};

}  // namespace javinolib
