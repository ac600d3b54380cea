#pragma once

#include <stdint.h>

#include "../storage/KeyStore.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Some bits for each place of a key: on a small board each is false.
/// @tparam FLAGS how many for each
template <uint8_t FLAGS>
class KeyFlags {
 public:
  bool has(uint8_t slot, uint8_t flag = 0) const {
    return config::LARGE && slot != KeyStore::NO_SLOT && (bytes_[byteOf(slot, flag)] & bitOf(slot)) != 0;
  }

  void set(uint8_t slot, bool on, uint8_t flag = 0) {
    if (!config::LARGE || slot == KeyStore::NO_SLOT) return;
    uint8_t &byte = bytes_[byteOf(slot, flag)];
    byte = static_cast<uint8_t>(on ? byte | bitOf(slot) : byte & ~bitOf(slot));
  }

 private:
  static const uint8_t BYTES = (KeyStore::PLACES + 7) / 8;

  static uint8_t byteOf(uint8_t slot, uint8_t flag) { return static_cast<uint8_t>(flag * BYTES + slot / 8); }
  static uint8_t bitOf(uint8_t slot) { return static_cast<uint8_t>(1 << (slot & 7)); }

  uint8_t bytes_[config::LARGE ? FLAGS * BYTES : 1] JAVINO_ZEROED;
};

}  // namespace javinolib
