#pragma once

#include <cstdint>
#include <string>
#include <vector>

typedef std::vector<uint8_t> Bytes;

/// Reads pairs of hexadecimal digits; throws where the text is anything else.
Bytes fromHex(const std::string &hex);

std::string toHex(const Bytes &bytes);

/// The bytes of a text.
Bytes bytesOf(const std::string &text);

std::string textOf(const Bytes &bytes);

/// A nonce's six bytes.
Bytes nonce(uint32_t epoch, uint32_t counter);

Bytes operator+(const Bytes &head, const Bytes &tail);

/// Whether `part` occurs anywhere in `whole`.
bool contains(const Bytes &whole, const Bytes &part);

/// `count` bytes from a seeded generator.
class RandomBytes {
 public:
  explicit RandomBytes(uint32_t seed) : state_(seed | 1) {}
  uint32_t number(uint32_t below);
  uint8_t byte() { return static_cast<uint8_t>(number(256)); }
  Bytes bytes(size_t count);

 private:
  uint32_t state_;
};
