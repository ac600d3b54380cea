#pragma once

#include "../addressing/Address.h"
#include "../support/NoInline.h"

namespace javino {

/// The board's own address, which EEPROM keeps (SPEC 4.3, set RF id).
class RfId {
 public:
  RfId() : address_(Address::serialLine()) {}

  /// Reads what is stored. To be called once, after a boot.
  void begin();

  bool isSet() const { return address_.isDevice(); }

  /// The device address, or `++++` where none is set.
  const Address &address() const { return address_; }

  /// Stores a device address; one that is there already is not written again.
  /// @return false where the EEPROM did not keep it; then none is set.
  bool set(const Address &address);

 private:
  Address address_;
};

}  // namespace javino
