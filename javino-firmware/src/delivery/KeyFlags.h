#pragma once

#include <stdint.h>

#include "../storage/KeyStore.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// One bit for each place of a key: on a small board each is false.
class KeyFlags {
 public:
  bool has(uint8_t slot) const {
    return config::LARGE && slot != KeyStore::NO_SLOT && (bytes_[slot / 8] & bitOf(slot)) != 0;
  }

  void set(uint8_t slot, bool on) {
    if (!config::LARGE || slot == KeyStore::NO_SLOT) return;
    uint8_t &byte = bytes_[slot / 8];
    byte = static_cast<uint8_t>(on ? byte | bitOf(slot) : byte & ~bitOf(slot));
  }

 private:
  static uint8_t bitOf(uint8_t slot) { return static_cast<uint8_t>(1 << (slot & 7)); }

  uint8_t bytes_[config::LARGE ? (KeyStore::PLACES + 7) / 8 : 1] JAVINO_ZEROED;
};

}  // namespace javinolib
