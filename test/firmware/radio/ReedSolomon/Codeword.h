#pragma once

#include <algorithm>
#include <random>

#include "radio/ReedSolomon.h"
#include "support/ReferencePacket.h"

using javinolib::reedsolomon::PARITY_LENGTH;
using javinolib::reedsolomon::Progress;

// Steps after which a decoder that has not ended never will.
const int MOST_STEPS = 40;

inline Bytes withParity(Bytes bytes) {
  Bytes parity(PARITY_LENGTH, 0xA5);  // what was there before
  javinolib::reedsolomon::encode(bytes.data(), static_cast<uint8_t>(bytes.size()), parity.data());
  bytes.insert(bytes.end(), parity.begin(), parity.end());
  return bytes;
}

inline Progress finish(javinolib::reedsolomon::Decoder &decoder) {
  Progress progress = Progress::PENDING;
  for (int i = 0; i < MOST_STEPS && progress == Progress::PENDING; i++) progress = decoder.step();
  return progress;
}

inline Progress mend(Bytes &codeword, const Bytes &erasures) {
  javinolib::reedsolomon::Decoder decoder;
  decoder.begin(codeword.data(), static_cast<uint8_t>(codeword.size()));
  for (uint8_t position : erasures) decoder.erase(position);
  return finish(decoder);
}

// So many different positions.
inline Bytes somePositions(size_t length, size_t count, std::mt19937 &random) {
  Bytes positions(length);
  for (size_t i = 0; i < length; i++) positions[i] = static_cast<uint8_t>(i);
  std::shuffle(positions.begin(), positions.end(), random);
  positions.resize(count);
  return positions;
}

// A codeword's bytes at some positions replaced by wrong ones.
inline Bytes damagedAt(Bytes codeword, const Bytes &positions, std::mt19937 &random) {
  for (uint8_t position : positions) codeword[position] ^= static_cast<uint8_t>(1 + random() % 255);
  return codeword;
}

// The definition: a polynomial that is 0 at alpha ... alpha^16, computed bit by bit.
inline bool isCodeword(const Bytes &bytes) {
  uint8_t root = 1;
  for (int i = 0; i < PARITY_LENGTH; i++) {
    const auto doubled = [](uint8_t value) { return static_cast<uint8_t>(value << 1 ^ (value & 0x80 ? 0x1D : 0)); };
    root = doubled(root);
    uint8_t value = 0;
    for (uint8_t byte : bytes) {
      uint8_t product = 0;
      for (uint8_t bit = 0x80; bit != 0; bit >>= 1) {
        product = doubled(product);
        if (root & bit) product ^= value;
      }
      value = product ^ byte;
    }
    if (value != 0) return false;
  }
  return true;
}
