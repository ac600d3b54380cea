#pragma once

#include <stdint.h>

#include "../support/CoreTypes.h"
#include "PortType.h"

namespace javinolib {

/// The bytes between host and board; no function waits. The seam for the port; bound when linking, to
/// HostPort.cpp on a board and to a line in memory in the host tests, since virtual functions would take 276
/// bytes of flash.
class SerialPort {
 public:
  explicit SerialPort(Stream &serial) : serial_(serial) {}

  /// Opens the port, 8N1.
  void begin(unsigned long baud);

  /// @return whether read() has a byte. Safe to call with interrupts off, as is canWrite().
  bool canRead() const;

  /// The next byte that came; only while canRead().
  uint8_t read();

  /// @return whether write() takes a byte without waiting.
  bool canWrite() const;

  /// Sends a byte; only while canWrite().
  void write(uint8_t byte);

 private:
  Stream &serial_;  // a UART, or the USB of chips that have their own
#ifndef __AVR__
  mutable PortRoom room_;
#endif
};

}  // namespace javinolib
