#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../addressing/Address.h"
#include "../framing/Limits.h"

namespace javino {

/// A message from the air, opened.
struct ReceivedMessage {
  Address destination;
  Address origin;
  uint8_t length;  ///< of the content, 0…67 bytes
  uint8_t content[MAX_PLAIN_RADIO_CONTENT];
};

/// Received messages in the order in which they came, each with a number, until the host says that it has taken them
/// over (SPEC 4.3, poll).
class ReceiveQueue {
 public:
  ReceiveQueue() : first_(0), count_(0), firstNumber_(0) {}

  bool isFull() const { return count_ == config::RECEIVE_QUEUE; }
  uint8_t count() const { return count_; }

  /// The place for the next message, to be filled and then taken in by commit(). Only while it is not full.
  ReceivedMessage &next() { return messages_[(first_ + count_) % config::RECEIVE_QUEUE]; }
  void commit() { count_++; }

  /// @param index 0, the oldest, … count() - 1
  const ReceivedMessage &message(uint8_t index) const { return messages_[(first_ + index) % config::RECEIVE_QUEUE]; }

  /// The number of a message: 0 for the first since the boot, …, 255, 0, …
  uint8_t numberOf(uint8_t index) const { return static_cast<uint8_t>(firstNumber_ + index); }

  /// Forgets the message of this number and all before it; does nothing where it is not here (any more).
  void forgetUpTo(uint8_t number);

 private:
  uint8_t first_;
  uint8_t count_;
  uint8_t firstNumber_;
  ReceivedMessage messages_[config::RECEIVE_QUEUE];
};

}  // namespace javino
