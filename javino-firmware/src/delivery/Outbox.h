#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Frame.h"
#include "../framing/Limits.h"
#include "ByteQueue.h"
#include "Outcomes.h"

namespace javinolib {

/// Messages that wait for the air or are under way, in the order of their numbers, as frames: those that are to be sealed
/// with room for nonce and tag. Each stays until it has ended.
class Outbox {
 public:
  Outbox() : records_(block_, sizeof block_) {}

  /// Whether a frame of this length, in bytes with its header and, if it is to be sealed, SEAL_LENGTH, can be taken in.
  bool fits(Length frameLength) const;

  /// Takes in a broadcast as it is. Only while HEADER_LENGTH and its message fit.
  /// @return the transmission's number
  uint8_t addPlain(const Frame &frame);

  /// Takes in a content to be sealed. Only while HEADER_LENGTH, SEAL_LENGTH and it fit.
  /// @return the transmission's number
  uint8_t addUnsealed(const Frame &frame);

  /// How many there are.
  uint8_t count() const { return records_.count(); }

  /// Goes through the frames, each with a byte more, its number: no bytes stand for the end.
  JAVINO_NOINLINE ByteQueue::Record first() const { return records_.first(); }
  JAVINO_NOINLINE ByteQueue::Record after(ByteQueue::Record record) const { return records_.after(record); }
  static uint8_t numberOf(ByteQueue::Record record) { return record.bytes[record.length - 1]; }

  /// Whether a message to this address waits or is under way.
  bool hasFor(const Address &destination) const;

  /// The frame of this number, which has not ended.
  JAVINO_NOINLINE ByteQueue::Record find(uint8_t number) const;

  /// The transmission of this number ends.
  void close(uint8_t number, Outcome outcome);

  Outcomes &outcomes() { return outcomes_; }

 private:
  static_assert(config::TRANSMIT_BYTES >= 3 + HEADER_LENGTH + SEAL_LENGTH + MAX_CONTENT_LENGTH,
                "TRANSMIT_BYTES: too few");

  uint8_t add(const Frame &frame, uint8_t contentAt, Length length);

  ByteQueue records_;
  Outcomes outcomes_;
  uint8_t nextNumber_ JAVINO_ZEROED;
  uint8_t block_[config::TRANSMIT_BYTES];
};

}  // namespace javinolib
