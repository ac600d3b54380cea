#pragma once

#include <stdint.h>

#include "../support/BigEndian.h"
#include "../support/Inlining.h"
#include "../support/Status.h"
#include "../support/Part.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// The first half of each nonce (SPEC 5.1): raised by one in each boot and stored before anything is sent, so that no
/// epoch is ever used in two boots. A host can raise it further.
///
/// A ring of records (Config.h: 16) takes the epochs in turn, each of them twice: in the two places behind the highest
/// epoch so far. One is before all keys and one behind all floors, so that a sketch that writes over one end of what is ours
/// does no harm. A write that is torn by a loss of power leaves the earlier epochs whole, and an epoch counts as
/// stored when both copies are there: so a place that decays later does not make it come again.
///
/// A board without keys fills the ring. So where the two places behind the highest epoch cannot be read, something else
/// has written there, perhaps over a higher one. If keys are stored, the epoch is lost then: which nonces these keys have
/// had, nobody here knows. Nothing is stored until a host raises it.
///
/// Wear: a boot changes two places, the seal of each twice (erased, written). Cells last 100 000 writes, a place
/// 50 000 boots that use it, the ring of 16 places 400 000 boots: 20 boots an hour for more than two years. A place
/// that is worn out is passed over.
class BootEpoch {
 public:
  /// 0xFFFFFF stands for "none left" and is never used in a nonce.
  static const Uint24 NONE_LEFT = 0xFFFFFF;

  /// Raises the epoch and stores it: some 60 ms. To be called once, after a boot.
  /// @param hasKeys whether keys are stored, which epochs before may have used
  void begin(bool hasKeys);

  /// Goes on with a higher epoch, and stores it: some 30 ms.
  /// @param epoch above value(), and below NONE_LEFT
  void raise(Uint24 epoch) { store(findHighest(), epoch); }

  /// 1…0xFFFFFE, NONE_LEFT, or 0 where it is lost.
  Uint24 value() const { return value_; }

  /// OK where it may be used; EPOCH_LOST, NONCE_EXHAUSTED, or STORE_FAILED where the EEPROM did not keep it.
  Status status() const { return status_; }

 private:
  JAVINO_NOINLINE uint8_t findHighest();
  JAVINO_NOINLINE void store(uint8_t highest, Uint24 epoch);

  Uint24 value_ JAVINO_ZEROED;
  Status status_ JAVINO_ZEROED;
};

#ifdef __AVR__
template <>
BootEpoch &Part<BootEpoch>::the();
#endif

}  // namespace javinolib
