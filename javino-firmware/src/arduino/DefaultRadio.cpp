#include "../radio/AskRadio.h"
#include "JavinoBoard.h"

namespace javino {

// Apart from the rest, and made on first use: a sketch that brings its own radio links no AskRadio.
static Radio &defaultRadio() {
  static AskRadio radio;
  return radio;
}

Javino::Javino(HostSerial &serial, const char *firmwareName) : Javino(serial, firmwareName, defaultRadio()) {}

}  // namespace javino
