#pragma once

#include "../board/PortType.h"
#include "../board/SerialPort.h"
#include "../support/Core.h"

namespace javinolib {

/// The type of `Serial`: a UART, or the USB of chips that have their own.
typedef decltype(Serial) HostSerial;

/// The host's line on another port. The sketch that calls it links OtherPort.cpp in place of HostPort.cpp.
SerialPort otherPort(Stream &port, void (*begin)(Stream &, unsigned long), int (*room)(Stream &));

inline SerialPort hostPort(HostSerial &port) { return SerialPort(port); }

template <typename Port>
SerialPort hostPort(Port &port) {
  return otherPort(port, PortType<Port>::begin, PortType<Port>::room);
}

}  // namespace javinolib
