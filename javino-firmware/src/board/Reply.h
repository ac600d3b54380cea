#pragma once

#include <stdint.h>

#include "../framing/Limits.h"
#include "../support/Flash.h"
#include "../support/Inlining.h"
#include "../support/Status.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// The reply to a request, from the first byte of its body to the packet, in the place of that request (SPEC 4.1, 4.2). So who
/// performs it reads all of it before adding to the body.
///
/// The next packet from the host takes its place. Only the first bytes of its message are kept, for repeats of the request:
/// they are all that is said of one that changes anything.
class Reply {
 public:
  /// @param bytes of `room` bytes, that of the CRC with it
  Reply(uint8_t *bytes, Length room) : bytes_(bytes), bodyEnd_(static_cast<Length>(room - CRC_LENGTH)) {}

  /// Begins a reply without a body.
  void begin() { length_ = STATUS_AT + 1; }

  /// Sets the status; any but OK takes the body away. To be called when the request is not needed any more.
  void setStatus(Status status);

  /// The bytes that still fit the body.
  Length room() const { return static_cast<Length>(bodyEnd_ - length_); }

  /// Appends to the body; what does not fit is refused whole.
  JAVINO_NOINLINE bool add(uint8_t byte) { return add(&byte, 1); }
  JAVINO_NOINLINE bool add(const uint8_t *bytes, Length length);

  /// A place in the body, to come back to with truncate() or replace().
  Length mark() const { return length_; }
  void truncate(Length mark) { length_ = mark; }
  void replace(Length mark, uint8_t byte) { bytes_[mark] = byte; }

  /// Writes the header before the body; the sequence byte is the request's.
  void finish();

  /// Makes the last reply again in the place of a repeat of its request.
  /// @return false where more was said than is kept
  bool recall();

  /// The packet before CRC and COBS: sequence and frame. There is room behind it for the CRC.
  uint8_t *packet() { return bytes_; }
  Length packetLength() const { return length_; }

 private:
  static const uint8_t STATUS_AT = 1 + HEADER_LENGTH;
  static const uint8_t CRC_LENGTH = 2;
  static const uint8_t KEPT_LENGTH = 4;  // status and a key's check value (SPEC 4.3)

  friend class Record;

  uint8_t *const bytes_;
  const Length bodyEnd_;
  Length length_ JAVINO_ZEROED;
  uint8_t kept_[KEPT_LENGTH];
};

/// A record of a poll reply while it is written: `type(1) length(2) value` (SPEC 4.3). It gets into the reply whole or
/// not at all.
class Record {
 public:
  Record(Reply &reply, char type);

  JAVINO_NOINLINE void add(uint8_t byte) { add(&byte, 1); }
  JAVINO_NOINLINE void add(const uint8_t *bytes, Length length);
  JAVINO_NOINLINE void add(const FlashText *text);

  /// Ends the record, which only then gets into the reply.
  /// @return false, and the reply is as it was before, where it did not fit.
  bool close();

 private:
  static const uint8_t HEAD_LENGTH = 3;

  Reply &reply_;
  uint8_t *at_;  // the place of the next byte; null where one did not fit
  const uint8_t *const end_;
};

}  // namespace javinolib
