#pragma once

#include <gmock/gmock.h>
#include <stdint.h>

/// Stands behind `EEPROM` while it lives; there is at most one at a time.
class EepromMock {
 public:
  EepromMock();
  ~EepromMock();

  MOCK_METHOD(uint8_t, read, (int at));
  MOCK_METHOD(void, write, (int at, uint8_t value));
};
