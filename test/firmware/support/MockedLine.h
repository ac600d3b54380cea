#pragma once

#include <SerialMock.h>
#include <gmock/gmock.h>

#include <deque>

#include "Bytes.h"

/// `Serial` as a UART with a buffer of 64 bytes, whose other end is the test's.
class MockedLine {
 public:
  MockedLine() {
    using testing::_;
    using testing::Invoke;
    ON_CALL(serial, available()).WillByDefault(Invoke([this] { return static_cast<int>(in.size()); }));
    ON_CALL(serial, read()).WillByDefault(Invoke([this] {
      const uint8_t byte = in.front();
      in.pop_front();
      return byte;
    }));
    ON_CALL(serial, availableForWrite()).WillByDefault(Invoke([this] { return 63 - static_cast<int>(out.size()); }));
    ON_CALL(serial, write(_)).WillByDefault(Invoke([this](uint8_t byte) {
      EXPECT_LT(out.size(), 63u) << "write() would block";
      out.push_back(byte);
      return 1u;
    }));
  }

  void arrive(const Bytes &bytes) { in.insert(in.end(), bytes.begin(), bytes.end()); }

  testing::NiceMock<SerialMock> serial;
  std::deque<uint8_t> in;
  Bytes out;
};
