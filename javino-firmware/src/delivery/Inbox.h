#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Frame.h"
#include "../secure/ReplayMemory.h"
#include "../storage/KeyStore.h"
#include "../support/Inlining.h"
#include "Acknowledger.h"
#include "ByteQueue.h"
#include "UnknownKeyReports.h"
#include "../support/Zeroed.h"
#include "../support/Part.h"

namespace javinolib {

/// Received messages in the order in which they came, each with a number, until the host says that it has taken them
/// over (SPEC 4.3, poll). Then a sealed one's nonce is remembered, and a unicast acknowledged (SPEC 7.2).
class Inbox {
 public:
  /// A message in place, as the host is to get it.
  struct Message {
    const uint8_t *addresses;  ///< destination(4) origin(4)
    const uint8_t *nonce;      ///< 6 bytes, all 0 for a broadcast
    const uint8_t *content;
    Length length;  ///< of the content
  };

  /// The parts of a sealed frame that wait here.
  enum Waiting : uint8_t {
    NOTHING,  ///< neither it nor what was sealed later by the same origin
    THIS,     ///< the very frame
    LATER     ///< one that was sealed later
  };

  Inbox(ReplayMemory &replays, Acknowledger &acknowledger)
      : replays_(replays), acknowledger_(acknowledger), records_(block_, sizeof block_) {}

  /// Whether there is room for a content of this length.
  bool fits(uint16_t contentLength) const { return records_.fits(static_cast<Length>(HEAD_LENGTH + contentLength)); }

  /// Takes in a broadcast, or a message that is opened. Only while it fits.
  /// @param slot the place of its key, or NO_SLOT
  /// @param frame all of it
  /// @param length of its content
  JAVINO_NOINLINE void add(uint8_t slot, const uint8_t *frame, Length length);

  /// Lends memory for a frame that comes in fragments, until takeBack(); null where messages are there. What is added next may
  /// still lie in it.
  uint8_t *lend() { return records_.lend(MAX_FRAME_LENGTH); }
  void takeBack() { records_.takeBack(MAX_FRAME_LENGTH); }

  /// The frames that could not be taken in for want of a key.
  UnknownKeyReports &unknownKeys() { return unknownKeys_; }
  const UnknownKeyReports &unknownKeys() const { return unknownKeys_; }

  Waiting waiting(uint8_t slot, const Address &origin, const uint8_t *nonce) const;

  /// The host has taken over the message of this number and all before it; nothing is done where it is not here.
  template <typename Scope = WholeScope>
  void taken(uint8_t number);

  /// To be called when keys were deleted: what came under them is neither remembered nor acknowledged.
  void keysChanged(const KeyStore &keys);

  /// Goes through the messages: no bytes stand for the end.
  JAVINO_NOINLINE ByteQueue::Record first() const { return records_.first(); }
  JAVINO_NOINLINE ByteQueue::Record after(ByteQueue::Record record) const { return records_.after(record); }
  static Message read(ByteQueue::Record record);

  /// The number of the first message: 0 for the first since the boot, …, 255, 0, …
  uint8_t firstNumber() const { return firstNumber_; }

 private:
  // A record: slot(1), destination(4), origin(4), nonce(6), content.
  static const uint8_t DESTINATION_AT = 1;
  static const uint8_t ORIGIN_AT = DESTINATION_AT + Address::TEXT_LENGTH;
  static const uint8_t NONCE_AT = ORIGIN_AT + Address::TEXT_LENGTH;
  static const uint8_t HEAD_LENGTH = NONCE_AT + NONCE_LENGTH;

  static_assert(config::RECEIVE_BYTES >= 2 + HEAD_LENGTH + MAX_CONTENT_LENGTH, "RECEIVE_BYTES: too few");

  template <typename Scope>
  void settle(const uint8_t *record);

  Part<ReplayMemory> replays_;
  Part<Acknowledger> acknowledger_;
  ByteQueue records_;
  uint8_t firstNumber_ JAVINO_ZEROED;
  UnknownKeyReports unknownKeys_;
  uint8_t block_[config::RECEIVE_BYTES];
};

}  // namespace javinolib
