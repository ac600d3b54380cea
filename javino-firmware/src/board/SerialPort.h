#pragma once

#include <stdint.h>

/// A UART of the Arduino core.
class HardwareSerial;

namespace javino {

/// The bytes between host and board; no function waits. The seam for the UART; bound when linking, to
/// ArduinoSerialPort.cpp on a board and to a line in memory in the host tests, since virtual functions would take 276
/// bytes of flash.
class SerialPort {
 public:
  explicit SerialPort(HardwareSerial &serial) : serial_(serial) {}

  /// @return whether read() has a byte. Safe to call with interrupts off, as is canWrite().
  bool canRead() const;

  /// The next byte that came; only while canRead().
  uint8_t read();

  /// @return whether write() takes a byte without waiting.
  bool canWrite() const;

  /// Sends a byte; only while canWrite().
  void write(uint8_t byte);

 private:
  HardwareSerial &serial_;
};

}  // namespace javino
