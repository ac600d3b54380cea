#pragma once

#include <stdint.h>

#include "../framing/Limits.h"
#include "../support/NoInline.h"
#include "Status.h"

namespace javino {

/// The reply to a request, from the first byte of its body to the finished packet, in one buffer (SPEC 4.1, 4.2).
/// It stays until the next begin(), so that a repeated request can be answered from it.
class Reply {
 public:
  Reply() : length_(0) {}

  /// Begins an OK without a body.
  /// @param sequence that of the request
  void begin(uint8_t sequence);

  /// Sets the status; any but OK takes the body away.
  void setStatus(Status status);

  /// The bytes that still fit the body.
  uint16_t room() const { return static_cast<uint16_t>(BODY_END - length_); }

  /// Appends to the body; what does not fit is refused whole.
  JAVINO_NOINLINE bool add(uint8_t byte) { return add(&byte, 1); }
  JAVINO_NOINLINE bool add(const uint8_t *bytes, uint16_t length);

  /// A place in the body, to come back to with truncate() or replace().
  uint16_t mark() const { return length_; }
  void truncate(uint16_t mark) { length_ = mark; }
  void replace(uint16_t mark, uint8_t byte) { bytes_[mark] = byte; }

  /// Writes header and CRC around the body.
  void finish();

  /// The finished packet before COBS: sequence, frame, CRC.
  const uint8_t *packet() const { return bytes_; }
  uint16_t packetLength() const { return length_; }

 private:
  static const uint8_t STATUS_AT = 1 + HEADER_LENGTH;
  static const uint16_t BODY_END = STATUS_AT + MAX_MESSAGE_LENGTH;

  uint16_t length_;
  uint8_t bytes_[MAX_PACKET_LENGTH];
};

}  // namespace javino
