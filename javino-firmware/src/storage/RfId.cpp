#include "RfId.h"

#include "../support/BigEndian.h"
#include "EepromLayout.h"

namespace javino {

void RfId::begin() {
  uint8_t stored[Address::STORED_LENGTH];
  const EepromRecord record(eeprom_, RF_ID_AT, sizeof stored);
  const Address address(record.read(stored) ? readUint24(stored) : Address().value());
  address_ = address.isDevice() ? address : Address();
}

bool RfId::set(const Address &address) {
  uint8_t stored[Address::STORED_LENGTH];
  writeUint24(stored, address.value());
  const bool kept = EepromRecord(eeprom_, RF_ID_AT, sizeof stored).write(stored);
  address_ = kept ? address : Address();
  return kept;
}

}  // namespace javino
