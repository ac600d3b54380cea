#include <Arduino.h>

#include "../board/SerialPort.h"

namespace javino {

bool SerialPort::canRead() const { return serial_.available() > 0; }

uint8_t SerialPort::read() { return static_cast<uint8_t>(serial_.read()); }

// The core's write() waits when its buffer of 64 bytes is full, so it is never called then.
bool SerialPort::canWrite() const { return serial_.availableForWrite() > 0; }

void SerialPort::write(uint8_t byte) { serial_.write(byte); }

}  // namespace javino
