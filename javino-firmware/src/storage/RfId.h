#pragma once

#include <stdint.h>

#include "../framing/Address.h"
#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// The board's own address, which EEPROM keeps (SPEC 4.3, set RF id).
///
/// Two places take it in turn; the old one is erased when the new one stands. So a loss of power at any moment leaves
/// the old or the new: where both are there, the newer generation counts and begin() erases the other.
class RfId {
 public:
  RfId() : address_(Address::serialLine()) {}

  /// Reads what is stored. To be called once, after a boot.
  void begin();

  bool isSet() const { return address_.isDevice(); }

  /// The device address, or `++++` where none is set.
  const Address &address() const { return address_; }

  /// Stores a device address, some 35 ms; one that is there already is not written again.
  /// @return false where the EEPROM did not keep it, or not erase the old one; address() is what is stored then.
  bool set(const Address &address);

 private:
  bool read(uint8_t place);

  Address address_;
  uint8_t place_ JAVINO_ZEROED;       // of the address
  uint8_t generation_ JAVINO_ZEROED;  // raised by one (mod 256) with each address
};

}  // namespace javinolib
