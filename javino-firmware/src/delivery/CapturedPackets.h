#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../radio/RadioPacket.h"
#include "../support/Counters.h"
#include "../support/Inlining.h"
#include "../support/Part.h"
#include "ByteQueue.h"
#include "../support/Zeroed.h"

namespace javinolib {

#if JAVINO_LARGE

/// All packets that the board has heard on the air, until the host has had them (SPEC 4.3, overhear). No key is needed for it,
/// and none is used. It is off at first.
class CapturedPackets {
 public:
  /// How a packet came.
  enum How : uint8_t { INTACT = 0, MENDED = 1, DAMAGED = 2 };

  explicit CapturedPackets(Counters &counters) : counters_(counters), records_(block_, sizeof block_) {}

  /// Begins to keep what is heard, or forgets all of it.
  void listen(bool on);

  /// A packet has come.
  /// @param payload of 1…77 bytes
  void add(How how, const uint8_t *payload, uint8_t length);

  /// A packet has come that is damaged beyond mending.
  void add(const RadioPacket &lost);

  /// Whether packets are to be told.
  bool arePending() const { return told_ != records_.count(); }

  /// Goes through those that are to be told: no bytes stand for the end. Each record is a value as SPEC 4.3 has it.
  ByteQueue::Record firstPending() const;
  ByteQueue::Record after(ByteQueue::Record record) const { return records_.after(record); }

  /// One more is told now.
  void tell() { told_++; }

  /// The host has had all that was told.
  JAVINO_NOINLINE void forgetTold();

  /// The host may not have had it.
  void keepTold() { told_ = 0; }

 private:
  static const uint8_t HEAD_LENGTH = 4 + 1;  // time, how

  JAVINO_NOINLINE uint8_t *append(How how, uint8_t length);

  Part<Counters> counters_;
  bool listens_ JAVINO_ZEROED;
  uint8_t told_ JAVINO_ZEROED;
  ByteQueue records_;
  uint8_t block_[config::OVERHEARD_BYTES];
};

#else

/// The substitute for it on a board that overhears nothing (Config.h).
class CapturedPackets {
 public:
  enum How : uint8_t { INTACT, MENDED };

  explicit CapturedPackets(Counters &) {}

  void listen(bool) {}
  void add(How, const uint8_t *, uint8_t) {}
  void add(const RadioPacket &) {}
  bool arePending() const { return false; }
  ByteQueue::Record firstPending() const { return {nullptr, 0}; }
  ByteQueue::Record after(ByteQueue::Record record) const { return record; }
  void tell() {}
  void forgetTold() {}
  void keepTold() {}
};

#endif

}  // namespace javinolib
