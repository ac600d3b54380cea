#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Frame.h"
#include "../framing/Limits.h"
#include "ByteQueue.h"
#include "Outcomes.h"

namespace javino {

/// Messages that wait for the air, in the order of their numbers, as frames: those that are to be sealed with room for
/// nonce and tag. The first one stays until it has ended.
class Outbox {
 public:
  Outbox() : records_(block_, sizeof block_) {}

  /// Whether a frame of this length, in bytes with its header and, if it is to be sealed, SEAL_LENGTH, can be taken in.
  bool fits(uint16_t frameLength) const { return !outcomes_.isFull() && records_.fits(frameLength); }

  /// Takes in a broadcast as it is. Only while HEADER_LENGTH and its message fit.
  /// @return the transmission's number
  uint8_t addPlain(const Frame &frame);

  /// Takes in a content to be sealed. Only while HEADER_LENGTH, SEAL_LENGTH and it fit.
  /// @return the transmission's number
  uint8_t addUnsealed(const Frame &frame);

  bool isEmpty() const { return records_.count() == 0; }

  /// The frame whose turn it is. Only while it is not empty.
  ByteQueue::Record first() const { return records_.first(); }

  /// That frame has ended.
  void close(Outcome outcome);

  Outcomes &outcomes() { return outcomes_; }

 private:
  static_assert(config::TRANSMIT_BYTES >= 2 + HEADER_LENGTH + SEAL_LENGTH + MAX_CONTENT_LENGTH,
                "JAVINO_TRANSMIT_BYTES: too few");

  uint8_t add(const Frame &frame, uint8_t contentAt, uint16_t length);

  ByteQueue records_;
  Outcomes outcomes_;
  uint8_t block_[config::TRANSMIT_BYTES];
};

}  // namespace javino
