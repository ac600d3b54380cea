#pragma once

/// Takes no interrupt here, and does nothing.
class SoftwareSerial {
 public:
  SoftwareSerial(int, int) {}
  void begin(long) {}
};
