#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

/// Ends the run, and has libFuzzer keep the input that led here, where something does not hold that always must.
inline void require(bool holds, const char *what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

/// The fuzzer's bytes, taken one decision after the other; zeros where they are used up.
class Input {
 public:
  Input(const uint8_t *data, size_t size) : at_(data), end_(data + size) {}

  bool empty() const { return at_ == end_; }

  uint8_t byte() { return empty() ? 0 : *at_++; }

  uint16_t word() {
    const uint8_t high = byte();
    return static_cast<uint16_t>(high << 8 | byte());
  }

  /// Up to `most` bytes, as the first one says.
  std::vector<uint8_t> bytes(size_t most) { return take(byte() % (most + 1)); }

  /// `count` bytes, or those that are left.
  std::vector<uint8_t> take(size_t count) {
    const size_t left = static_cast<size_t>(end_ - at_);
    const uint8_t *from = at_;
    at_ += count < left ? count : left;
    return std::vector<uint8_t>(from, at_);
  }

 private:
  const uint8_t *at_;
  const uint8_t *const end_;
};
