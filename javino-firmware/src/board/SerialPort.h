#pragma once

#include <stdint.h>

namespace javino {

/// The bytes between host and board. The seam for the UART; no function waits.
class SerialPort {
 public:
  /// @return whether read() has a byte. Safe to call with interrupts off, as is canWrite().
  virtual bool canRead() const = 0;

  /// The next byte that came; only while canRead().
  virtual uint8_t read() = 0;

  /// @return whether write() takes a byte without waiting.
  virtual bool canWrite() const = 0;

  /// Sends a byte; only while canWrite().
  virtual void write(uint8_t byte) = 0;

 protected:
  ~SerialPort() {}
};

}  // namespace javino
