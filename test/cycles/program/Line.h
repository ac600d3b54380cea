#pragma once

#include <stdint.h>

/// The board's serial port: bytes in memory.
struct Line {
  bool measured;       ///< the next byte that the board writes ends the measurement
  const uint8_t *in;   ///< the next byte that comes
  const uint8_t *end;  ///< behind the last one
  uint8_t *out;        ///< where the next byte that the board writes goes, null where it is dropped
};

extern Line line;
