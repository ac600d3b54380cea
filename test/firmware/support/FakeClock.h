#pragma once

#include <cstdint>

/// A clock that the test sets, to which the tests bind clock::millis(). The one that was made or told to be used last is
/// the chip's.
class FakeClock {
 public:
  FakeClock();
  ~FakeClock();
  FakeClock(const FakeClock &) = delete;
  FakeClock &operator=(const FakeClock &) = delete;

  /// Makes this the chip's: for tests with several boards.
  void use();

  uint32_t millis = 0;  ///< since the boot

 private:
  FakeClock *const before_;
};
