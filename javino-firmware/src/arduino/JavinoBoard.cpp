#include "JavinoBoard.h"

#include "Cpu.h"

namespace javinolib {

Javino::Javino(HostSerial &serial, const char *firmwareName, Radio &radio)
    : serial_(serial), board_(SerialPort(serial), radio, firmwareName) {}

bool Javino::begin(unsigned long baud) {
  serial_.begin(baud);
  const bool begun = board_.begin();
  // A host whose poll the board held before a reset asks again.
  serial_.write(static_cast<uint8_t>(0));
  return begun;
}

void Javino::run() {
  board_.run();
  cpu::holdInterrupts();
  if (board_.isIdle()) {
    cpu::releaseInterruptsAndIdle();
  } else {
    cpu::releaseInterrupts();
  }
}

}  // namespace javinolib
