#pragma once

#include <secure/ReplayMemory.h>

#include <memory>

#include "Bytes.h"
#include "SimulatedEeprom.h"
#include "SimulatedRam.h"

/// A replay memory with its keys, EEPROM and RAM, that can be reset and lose power.
class ReplayRig {
 public:
  static const uint8_t KEYS = 4;

  /// With keys in the places 0…3, and booted.
  ReplayRig();

  /// Boots with the RAM as it is.
  void reset();

  /// Boots with the RAM lost.
  void powerCycle();

  javinolib::ReplayMemory::Verdict judge(uint8_t key, const javinolib::Address &origin, const Bytes &nonce) const {
    return memory->judge(key, origin, nonce.data());
  }
  bool reserve(uint8_t key, const javinolib::Address &origin, const Bytes &nonce) {
    return memory->reserve(key, origin, nonce.data());
  }

  /// The steps of a board with a message: judge, reserve, and remember when the host takes it.
  /// @return whether it was accepted
  bool take(uint8_t key, const javinolib::Address &origin, const Bytes &nonce);

  Bytes floor(uint8_t key, const javinolib::Address &origin) const;

  SimulatedEeprom eeprom;
  SimulatedRam ram;
  javinolib::KeyStore keys;
  std::unique_ptr<javinolib::ReplayMemory> memory;
  uint32_t epoch = 0;
};
