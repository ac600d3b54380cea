#pragma once

#include <array>
#include <map>

#include "Bytes.h"

/// Thrown by an EEPROM whose power is cut.
struct PowerCut {};

/// 4096 cells, erased at first, that can lose power in the middle of a write, and wear out. The one that was made or told
/// to be used last is the chip's EEPROM.
class SimulatedEeprom {
 public:
  SimulatedEeprom();
  ~SimulatedEeprom();
  SimulatedEeprom(const SimulatedEeprom &) = delete;
  SimulatedEeprom &operator=(const SimulatedEeprom &) = delete;

  /// Makes this the chip's: for tests with several boards.
  void use();

  uint8_t read(uint16_t at) const { return cells_.at(at); }
  void update(uint16_t at, uint8_t value);

  /// Cuts the power at the write that comes after `writes` more: its cell then holds `garbage`.
  void cutPowerAfter(int writes, uint8_t garbage);
  void restorePower() { writesLeft_ = -1; }

  /// From now on this cell keeps what it has.
  void wearOut(uint16_t at) { worn_[at] = true; }

  /// Writes that changed a cell, in all and of one cell.
  int writes() const { return writes_; }
  int writesOf(uint16_t at) const;

  /// Sets a cell past all rules.
  void corrupt(uint16_t at, uint8_t value) { cells_.at(at) = value; }

  Bytes content() const { return Bytes(cells_.begin(), cells_.end()); }

 private:
  SimulatedEeprom *const before_;
  std::array<uint8_t, 4096> cells_;
  std::map<uint16_t, bool> worn_;
  std::map<uint16_t, int> writesOf_;
  int writes_ = 0;
  int writesLeft_ = -1;
  uint8_t garbage_ = 0;
};
