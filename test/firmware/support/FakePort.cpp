#include "FakePort.h"

#include <board/SerialPort.h>

#include <stdexcept>

namespace javinolib {

// Each port of these tests is a FakePort.
void SerialPort::begin(unsigned long) {}
bool SerialPort::canRead() const { return static_cast<FakePort &>(serial_).canRead(); }
uint8_t SerialPort::read() { return static_cast<FakePort &>(serial_).take(); }
bool SerialPort::canWrite() const { return static_cast<FakePort &>(serial_).canWrite(); }
void SerialPort::write(uint8_t byte) { static_cast<FakePort &>(serial_).put(byte); }

}  // namespace javinolib

bool FakePort::canRead() {
  if (looksLeft_ != 0 && --looksLeft_ == 0) arrive(late_);
  return !in_.empty();
}

void FakePort::arriveAtLook(int look, const Bytes &bytes) {
  looksLeft_ = look;
  late_ = bytes;
}

uint8_t FakePort::take() {
  if (in_.empty()) throw std::logic_error("take() without canRead()");
  const uint8_t byte = in_.front();
  in_.pop_front();
  return byte;
}

void FakePort::put(uint8_t byte) {
  if (room_ == 0) throw std::logic_error("put() without canWrite() would block");
  if (room_ != SIZE_MAX) room_--;
  out_.push_back(byte);
  ever_.push_back(byte);
}

Bytes FakePort::takeWritten() {
  Bytes written;
  written.swap(out_);
  return written;
}
