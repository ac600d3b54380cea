#include "OtherPort.h"

namespace javinolib {

namespace {

void (*beginPort)(Stream &, unsigned long);
int (*roomOfPort)(Stream &);
PortRoom roomTold;

}  // namespace

SerialPort otherPort(Stream &port, void (*begin)(Stream &, unsigned long), int (*room)(Stream &)) {
  beginPort = begin;
  roomOfPort = room;
  roomTold = PortRoom();
  return SerialPort(port);
}

void SerialPort::begin(unsigned long baud) { beginPort(serial_, baud); }

bool SerialPort::canRead() const { return serial_.available() > 0; }

uint8_t SerialPort::read() { return static_cast<uint8_t>(serial_.read()); }

bool SerialPort::canWrite() const { return roomTold.takes(roomOfPort(serial_)); }

void SerialPort::write(uint8_t byte) { serial_.write(byte); }

}  // namespace javinolib
