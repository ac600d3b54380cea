#pragma once

#include <stdint.h>

#include "../framing/Address.h"
#include "../support/Inlining.h"
#include "../support/Zeroed.h"
#include "EepromRecord.h"

namespace javinolib {

/// The board's own address, which EEPROM keeps (SPEC 4.3, set RF id).
///
/// Two places take it in turn; the old one is erased when the new one stands. So a loss of power at any moment leaves
/// the old or the new: where both are there, the newer generation counts and begin() erases the other.
class RfId {
 public:
  RfId() { id_.address = Address::serialLine(); }

  /// Reads what is stored. To be called once, after a boot.
  void begin();

  bool isSet() const { return address().isDevice(); }

  /// The device address, or `++++` where none is set.
  const Address &address() const { return id_.address; }

  /// Stores a device address, some 35 ms; one that is there already is not written again.
  /// @return false where the EEPROM did not keep it, or not erase the old one; address() is what is stored then.
  bool set(const Address &address);

 private:
  struct Id {
    Address address;
    uint8_t generation JAVINO_ZEROED;  // raised by one (mod 256) with each address
  };

  // As EEPROM has it, with room for its seal.
  struct Stored : Id {
    uint8_t seal[EepromRecord::CHECK_LENGTH];

    uint8_t *record() { return reinterpret_cast<uint8_t *>(this); }
  };

  Id id_;
  uint8_t place_ JAVINO_ZEROED;
};

}  // namespace javinolib
