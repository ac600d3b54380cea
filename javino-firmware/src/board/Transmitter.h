#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../radio/Radio.h"

namespace javino {

/// Feeds packets to the radio one after the other, numbers them, and keeps their outcomes until they are polled
/// (SPEC 4.3, record T).
///
/// Packets go out in the order of their numbers, so outcomes need no list: those from the first unreported to the
/// last sent number wait.
class Transmitter {
 public:
  /// Transmissions without a reported outcome, at most: a host that never polls gets QUEUE_FULL instead of losing
  /// outcomes. So many take 160 bytes of a poll reply, which leaves room for any message.
  static const uint8_t MAX_UNREPORTED = 32;

  explicit Transmitter(Radio &radio)
      : radio_(radio), first_(0), count_(0), onAir_(false), nextNumber_(0), nextSent_(0), nextReported_(0) {}

  /// Whether another packet can be taken in.
  bool isFull() const;

  /// Where to build the next packet, up to 77 bytes; commit() then takes it in. Only while it is not full.
  uint8_t *next() { return packets_[(first_ + count_) % config::TRANSMIT_QUEUE].payload; }

  /// @param length 1…77
  /// @return the transmission's number
  uint8_t commit(uint8_t length);

  /// Moves packets to the radio and sees when they are sent.
  void run();

  /// Whether run() has nothing to do.
  bool isIdle() const;

  /// Whether outcomes wait to be reported.
  bool hasOutcome() const { return nextReported_ != nextSent_; }

  /// The number of the oldest transmission that was sent and not yet reported; only while hasOutcome().
  uint8_t takeOutcome() { return nextReported_++; }

 private:
  struct Packet {
    uint8_t length;
    uint8_t payload[MAX_RADIO_PAYLOAD];
  };

  Radio &radio_;
  uint8_t first_;
  uint8_t count_;
  bool onAir_;
  uint8_t nextNumber_;
  uint8_t nextSent_;
  uint8_t nextReported_;
  Packet packets_[config::TRANSMIT_QUEUE];
};

}  // namespace javino
