#pragma once

#include <stddef.h>
#include <stdint.h>

/// Has no pins here.
class TwoWire {
 public:
  void begin() {}
  void beginTransmission(uint8_t) {}
  uint8_t endTransmission() { return 2; }
  uint8_t requestFrom(uint8_t, size_t) { return 0; }
  size_t write(uint8_t) { return 1; }
  int read() { return -1; }
};

static TwoWire Wire __attribute__((unused));
