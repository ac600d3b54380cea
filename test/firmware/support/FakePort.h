#pragma once

#include <Arduino.h>

#include <deque>

#include "Bytes.h"

/// A serial line in memory, to which the tests bind SerialPort: the test puts bytes in, and takes what the board wrote.
class FakePort : public HardwareSerial {
 public:
  bool canRead();
  uint8_t take();
  bool canWrite() const { return room_ > 0; }
  void put(uint8_t byte);

  void arrive(const Bytes &bytes) { in_.insert(in_.end(), bytes.begin(), bytes.end()); }

  /// Bytes that are there when the board looks for the n-th time from now, as an interrupt brings them.
  void arriveAtLook(int look, const Bytes &bytes);

  /// All that the board wrote since takeWritten().
  const Bytes &written() const { return out_; }
  Bytes takeWritten();

  /// All that the board ever wrote.
  const Bytes &everWritten() const { return ever_; }

  /// How many bytes put() takes until the next call; unlimited at first.
  void setRoom(size_t room) { room_ = room; }

 private:
  std::deque<uint8_t> in_;
  int looksLeft_ = 0;
  Bytes late_;
  Bytes out_;
  Bytes ever_;
  size_t room_ = SIZE_MAX;
};
