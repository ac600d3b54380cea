#pragma once

#include <stdint.h>

#include "Address.h"
#include "../support/Inlining.h"
#include "Limits.h"

namespace javinolib {

/// Why bytes are no frame, in the order in which it is checked (SPEC 2).
enum class FrameError : uint8_t {
  NONE,           ///< they are one
  TOO_SHORT,      ///< fewer than 10 bytes
  BAD_DIGIT,      ///< one of the first ten bytes is outside the alphabet
  PARTIAL_BYTE,   ///< the size is no multiple of 8
  SIZE_MISMATCH,  ///< the size is not the number of bits that follow the header
  BAD_ORIGIN      ///< the origin is neither a device nor `++++`
};

/// A frame, as a view on bytes that stay where they are (SPEC 2).
struct Frame {
  Address destination;
  Address origin;
  const uint8_t *message;
  Length length;  ///< of the message, 0…511 bytes

  /// Reads the ten bytes before a message: all of a frame but the message itself.
  /// @return BAD_DIGIT, PARTIAL_BYTE, BAD_ORIGIN or NONE; on a small board SIZE_MISMATCH for a size over 255; `into` has
  /// meaning only where NONE is returned.
  JAVINO_NOINLINE static FrameError parseHeader(const uint8_t *bytes, Frame &into);

  /// Reads a frame that fills `bytes` exactly; `into` has meaning only where NONE is returned.
  static FrameError parse(const uint8_t *bytes, Length length, Frame &into);

  /// Writes the ten bytes before a message.
  /// @param messageLength 0…511 bytes
  static void writeHeader(uint8_t *into, const Address &destination, const Address &origin, Length messageLength);

  /// Writes the last two of these bytes.
  JAVINO_NOINLINE static void writeSize(uint8_t *into, Length messageLength);
};

}  // namespace javinolib
