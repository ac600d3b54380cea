#include "Bytes.h"

#include <algorithm>
#include <stdexcept>

Bytes fromHex(const std::string &hex) {
  if (hex.size() % 2 != 0 || hex.find_first_not_of("0123456789abcdef") != std::string::npos) {
    throw std::invalid_argument("not lower-case hexadecimal: " + hex);
  }
  Bytes bytes;
  for (size_t i = 0; i < hex.size(); i += 2) {
    bytes.push_back(static_cast<uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

std::string toHex(const Bytes &bytes) {
  std::string hex;
  for (uint8_t byte : bytes) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

Bytes bytesOf(const std::string &text) { return Bytes(text.begin(), text.end()); }

std::string textOf(const Bytes &bytes) { return std::string(bytes.begin(), bytes.end()); }

Bytes nonce(uint32_t epoch, uint32_t counter) {
  return {static_cast<uint8_t>(epoch >> 16),   static_cast<uint8_t>(epoch >> 8),   static_cast<uint8_t>(epoch),
          static_cast<uint8_t>(counter >> 16), static_cast<uint8_t>(counter >> 8), static_cast<uint8_t>(counter)};
}

Bytes operator+(const Bytes &head, const Bytes &tail) {
  Bytes whole = head;
  whole.insert(whole.end(), tail.begin(), tail.end());
  return whole;
}

bool contains(const Bytes &whole, const Bytes &part) {
  return std::search(whole.begin(), whole.end(), part.begin(), part.end()) != whole.end();
}

// xorshift32: the same on every machine.
uint32_t RandomBytes::number(uint32_t below) {
  state_ ^= state_ << 13;
  state_ ^= state_ >> 17;
  state_ ^= state_ << 5;
  return static_cast<uint32_t>((static_cast<uint64_t>(state_) * below) >> 32);
}

Bytes RandomBytes::bytes(size_t count) {
  Bytes bytes(count);
  for (uint8_t &byte : bytes) byte = this->byte();
  return bytes;
}
