#pragma once

#include <array>
#include <map>

#include "Bytes.h"

/// Thrown by an EEPROM whose power is cut.
struct PowerCut {};

/// 4096 cells, erased at first, that can lose power in the middle of a write, and wear out. The one that was made or told
/// to be used last is the chip's EEPROM.
///
/// A cell is weak when power went while it was written and its bits lie between two values: from then on each reading of
/// it may give either, or some bits of each, until it is written whole.
class SimulatedEeprom {
 public:
  SimulatedEeprom();
  ~SimulatedEeprom();
  SimulatedEeprom(const SimulatedEeprom &) = delete;
  SimulatedEeprom &operator=(const SimulatedEeprom &) = delete;

  /// Makes this the chip's: for tests with several boards.
  void use();

  uint8_t read(uint16_t at);
  void write(uint16_t at, uint8_t value);

  /// Cuts the power at the write that comes after `writes` more: its cell then holds `garbage`.
  void cutPowerAfter(int writes, uint8_t garbage);
  void restorePower() { writesLeft_ = -1; }

  /// The same, but its cell is weak then: between what it held and erased, or between erased and what it was to hold.
  void cutPowerWeaklyAfter(int writes, uint32_t seed);

  /// Makes a cell weak past all rules: it reads `other` at times.
  void weaken(uint16_t at, uint8_t other) { weak_[at] = other; }

  /// From now on this cell keeps what it has.
  void wearOut(uint16_t at) { worn_[at] = true; }

  /// The next reading of this cell gives other bits than those it holds.
  void misreadOnce(uint16_t at) { misread_ = at; }

  /// Writes, in all and of one cell.
  int writes() const { return writes_; }
  int writesOf(uint16_t at) const;

  /// Sets a cell past all rules.
  void corrupt(uint16_t at, uint8_t value) { cells_.at(at) = value; }

  Bytes content() const { return Bytes(cells_.begin(), cells_.end()); }
  bool isWeak(uint16_t at) const { return weak_.count(at) != 0; }

 private:
  void cutIn(uint16_t at, uint8_t value);

  SimulatedEeprom *const before_;
  std::array<uint8_t, 4096> cells_;
  std::map<uint16_t, bool> worn_;
  std::map<uint16_t, int> writesOf_;
  int writes_ = 0;
  int writesLeft_ = -1;
  uint8_t garbage_ = 0;
  bool weakly_ = false;
  std::map<uint16_t, uint8_t> weak_;  // the value that a weak cell has beside its own
  int misread_ = -1;
  RandomBytes random_;
};
