#pragma once

#include <Arduino.h>

#include "../board/SerialPort.h"

namespace javino {

/// A UART of the Arduino core.
class ArduinoSerialPort : public SerialPort {
 public:
  explicit ArduinoSerialPort(HardwareSerial &serial) : serial_(serial) {}

  bool canRead() const override { return serial_.available() > 0; }
  uint8_t read() override { return static_cast<uint8_t>(serial_.read()); }
  // The core's write() waits when its buffer of 64 bytes is full, so it is never called then.
  bool canWrite() const override { return serial_.availableForWrite() > 0; }
  void write(uint8_t byte) override { serial_.write(byte); }

 private:
  HardwareSerial &serial_;
};

}  // namespace javino
