#pragma once

#include <gmock/gmock.h>
#include <stddef.h>
#include <stdint.h>

/// Stands behind `Serial` while it lives; there is at most one at a time.
class SerialMock {
 public:
  SerialMock();
  ~SerialMock();

  MOCK_METHOD(void, begin, (unsigned long baud));
  MOCK_METHOD(int, available, ());
  MOCK_METHOD(int, read, ());
  MOCK_METHOD(int, availableForWrite, ());
  MOCK_METHOD(size_t, write, (uint8_t byte));
};
