#pragma once

#include <stdint.h>

#include "../framing/Limits.h"

namespace javinolib {

/// A request of a host to a board: a view on the bytes of its frame (SPEC 4.2). The addresses are only compared with the serial
/// line's: a board without a radio needs none.
struct Request {
  static const char HELLO = 'H';
  static const char POLL = 'P';
  static const char STATISTICS = 'S';
  static const uint8_t POLL_LENGTH = 1 + 2 + 3;  ///< of a poll's body; a byte more says what is taken

  const uint8_t *frame;
  Length length;  ///< of the message
  bool toBoard;   ///< the destination is `++++`: not to be transmitted
  bool fromHost;  ///< so is the origin

  /// Reads a frame that fills `bytes` exactly.
  /// @return false, and `into` has no meaning, where they are none (SPEC 2; the origin may be any address)
  static bool parse(const uint8_t *bytes, Length length, Request &into);

  const uint8_t *message() const { return frame + HEADER_LENGTH; }

  /// Whether it is always performed, even if it is byte by byte the one before.
  bool isHello() const { return toBoard && length != 0 && *message() == HELLO; }
};

}  // namespace javinolib
