#pragma once

#include <stdint.h>

#include "../support/Flash.h"

namespace javinolib {

/// The data sheet of a module that carries bytes from UART to UART (SPEC 6.2). It lies in flash. All modules in
/// range have the same settings. The times are measured with two of them.
struct SerialModule {
  uint16_t baud;           ///< of its UART, up to 57 600
  uint8_t longestPayload;  ///< MIN_RADIO_PAYLOAD…MAX_RADIO_PAYLOAD: 6 less than what it sends in one piece
  uint8_t slotMillis;      ///< from the first byte given to it to the first that comes out of another, 1…255
  uint16_t airtimeMillis;  ///< to the last one that comes out, beside airtimeMicros
  uint16_t airtimeMicros;  ///< of each byte given to it
};

}  // namespace javinolib

#define JAVINO_SERIAL_MODULE(name, text, ...) extern const javinolib::SerialModule name;
#include "SerialModules.def"
#undef JAVINO_SERIAL_MODULE
