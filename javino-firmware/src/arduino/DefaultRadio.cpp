#include "../radio/AskRadio.h"
#include "JavinoBoard.h"

namespace javinolib {

// Apart from the rest: a sketch that brings its own radio does not link this file. It may be made after the board, which
// uses it from begin() on.
static AskRadio radio;

Javino::Javino(HostSerial &serial, const char *firmwareName) : Javino(serial, firmwareName, radio) {}

}  // namespace javinolib
