#include "RfId.h"

#include "../support/BigEndian.h"
#include "EepromLayout.h"

namespace javino {

void RfId::begin() {
  uint8_t stored[Address::STORED_LENGTH];
  const EepromRecord record(RF_ID_AT, sizeof stored);
  if (record.read(stored)) address_ = Address(readUint24(stored));
  if (!address_.isDevice()) address_ = Address::serialLine();
}

bool RfId::set(const Address &address) {
  uint8_t stored[Address::STORED_LENGTH];
  writeUint24(stored, address.value());
  const bool kept = EepromRecord(RF_ID_AT, sizeof stored).write(stored);
  address_ = kept ? address : Address::serialLine();
  return kept;
}

}  // namespace javino
