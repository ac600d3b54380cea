#pragma once

#include <stdint.h>

#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javino {

/// The first half of each nonce (SPEC 5.1): raised by one in each boot and stored before anything is sent, so that no
/// epoch is ever used in two boots. A host can raise it further.
///
/// A ring of records (Config.h: 16) takes the epochs in turn, each of them twice: in the two places behind the highest
/// epoch so far. A write that is torn by a loss of power leaves the earlier epochs whole, and an epoch counts as
/// stored when both copies are there: so a place that decays later does not make it come again.
///
/// Wear: a boot changes two places, the seal of each twice (erased, written). Cells last 100 000 writes, a place
/// 50 000 boots that use it, the ring of 16 places 400 000 boots: 20 boots an hour for more than two years. A place
/// that is worn out is passed over.
class BootEpoch {
 public:
  /// 0xFFFFFF stands for "none left" and is never used in a nonce.
  static const uint32_t NONE_LEFT = 0xFFFFFF;

  /// Raises the epoch and stores it: some 60 ms. To be called once, after a boot.
  JAVINO_NOINLINE void begin();

  /// Goes on with a higher epoch, and stores it: some 30 ms.
  /// @param epoch above value(), and below NONE_LEFT
  void raise(uint32_t epoch) { store(findHighest(), epoch); }

  /// 1…0xFFFFFE, or NONE_LEFT.
  uint32_t value() const { return value_; }

  /// Whether the EEPROM kept the epoch: where not, it must not be used.
  bool isStored() const { return stored_; }

 private:
  JAVINO_NOINLINE uint8_t findHighest();
  JAVINO_NOINLINE void store(uint8_t highest, uint32_t epoch);

  uint32_t value_ JAVINO_ZEROED;
  bool stored_ JAVINO_ZEROED;
};

}  // namespace javino
