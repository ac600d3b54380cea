#include "OtherPort.h"

// The seam SerialPort on the core's `Serial`, whose type is known, so that on an AVR no function is looked up in its table of
// virtual ones. The functions are weak: OtherPort.cpp, if a sketch names another port, takes their place.

namespace javinolib {

#ifdef __AVR__
#define JAVINO_PORT(call) static_cast<HostSerial &>(serial_).HostSerial::call
#else
#define JAVINO_PORT(call) static_cast<HostSerial &>(serial_).call
#endif
#define JAVINO_WEAK __attribute__((weak))

JAVINO_WEAK void SerialPort::begin(unsigned long baud) { JAVINO_PORT(begin(baud)); }

JAVINO_WEAK bool SerialPort::canRead() const { return JAVINO_PORT(available()) > 0; }

JAVINO_WEAK uint8_t SerialPort::read() { return static_cast<uint8_t>(JAVINO_PORT(read())); }

// The core's write() waits when its buffer of 64 bytes is full, so it is never called then.
JAVINO_WEAK bool SerialPort::canWrite() const {
#ifdef __AVR__
  return JAVINO_PORT(availableForWrite()) > 0;
#else
  return room_.takes(PortType<HostSerial>::room(serial_));
#endif
}

JAVINO_WEAK void SerialPort::write(uint8_t byte) { JAVINO_PORT(write(byte)); }

}  // namespace javinolib
