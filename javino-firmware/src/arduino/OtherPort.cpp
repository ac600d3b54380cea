#include "OtherPort.h"

#include <Arduino.h>

namespace javinolib {

namespace {

void (*beginPort)(Stream &, unsigned long);
int (*roomOfPort)(Stream &);
bool hasToldRoom;

}  // namespace

SerialPort otherPort(Stream &port, void (*begin)(Stream &, unsigned long), int (*room)(Stream &)) {
  beginPort = begin;
  roomOfPort = room;
  hasToldRoom = false;
  return SerialPort(port);
}

void SerialPort::begin(unsigned long baud) { beginPort(serial_, baud); }

bool SerialPort::canRead() const { return serial_.available() > 0; }

uint8_t SerialPort::read() { return static_cast<uint8_t>(serial_.read()); }

// A port that has never told any room, as SoftwareSerial, takes bytes all the same.
bool SerialPort::canWrite() const {
  const bool hasRoom = roomOfPort(serial_) > 0;
  if (hasRoom) hasToldRoom = true;
  return hasRoom || !hasToldRoom;
}

void SerialPort::write(uint8_t byte) { serial_.write(byte); }

}  // namespace javinolib
