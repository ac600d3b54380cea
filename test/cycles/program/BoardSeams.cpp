// The seams of a board: a line in memory, a clock that stands still, an EEPROM that is erased and keeps nothing.

#include <avr/io.h>

#include "Line.h"
#include "board/SerialPort.h"
#include "storage/Eeprom.h"
#include "storage/Retained.h"
#include "support/Clock.h"

Line line;

namespace javinolib {

static TakenNonces nonces;

bool SerialPort::canRead() const { return line.in != line.end; }
uint8_t SerialPort::read() { return *line.in++; }
bool SerialPort::canWrite() const { return true; }

void SerialPort::write(uint8_t byte) {
  if (line.measured && byte == 0) return;  // it says that a request has come
  if (line.measured) TWBR = 0;
  line.measured = false;
  if (line.out != nullptr) *line.out++ = byte;
}

uint8_t eeprom::read(uint16_t) { return 0xFF; }
void eeprom::write(uint16_t, uint8_t) {}
TakenNonces &retained::takenNonces() { return nonces; }

retained::Airtime &retained::airtime() {
  static Airtime airtime;
  return airtime;
}
bool retained::isClear() { return true; }
uint32_t clock::millis() { return 0; }

}  // namespace javinolib
