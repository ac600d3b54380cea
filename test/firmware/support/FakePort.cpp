#include "FakePort.h"

#include <stdexcept>

uint8_t FakePort::read() {
  if (in_.empty()) throw std::logic_error("read() without canRead()");
  const uint8_t byte = in_.front();
  in_.pop_front();
  return byte;
}

void FakePort::write(uint8_t byte) {
  if (room_ == 0) throw std::logic_error("write() without canWrite() would block");
  if (room_ != SIZE_MAX) room_--;
  out_.push_back(byte);
  ever_.push_back(byte);
}

Bytes FakePort::takeWritten() {
  Bytes written;
  written.swap(out_);
  return written;
}
