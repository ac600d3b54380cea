#pragma once

#include <Arduino.h>

#include <deque>
#include <stdexcept>

#include "Bytes.h"

/// A UART with the buffers of the Arduino core, of 63 bytes each: what comes beyond them is lost, and the test takes what was
/// written.
class FakeUart : public Stream {
 public:
  static const size_t ROOM = 63;

  void begin(unsigned long baudRate) { baud = baudRate; }
  int available() override { return static_cast<int>(in_.size()); }
  int availableForWrite() override { return static_cast<int>(ROOM - out_.size()); }

  int read() override {
    const uint8_t byte = in_.front();
    in_.pop_front();
    return byte;
  }

  size_t write(uint8_t byte) override {
    if (out_.size() == ROOM) throw std::logic_error("write() would block");
    out_.push_back(byte);
    return 1;
  }

  void arrive(const Bytes &bytes) {
    for (uint8_t byte : bytes) {
      if (in_.size() < ROOM) in_.push_back(byte);
    }
  }

  Bytes take(size_t most = SIZE_MAX) {
    Bytes taken;
    for (; !out_.empty() && taken.size() < most; out_.pop_front()) taken.push_back(out_.front());
    return taken;
  }

  unsigned long baud = 0;

 private:
  std::deque<uint8_t> in_, out_;
};
