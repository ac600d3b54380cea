#include "RfId.h"

#include "EepromLayout.h"

namespace javinolib {

static const uint8_t GENERATION_AT = Address::STORED_LENGTH;

static EepromRecord recordAt(uint8_t place) {
  return EepromRecord(static_cast<uint16_t>(RF_ID_AT + place * RF_ID_RECORD_LENGTH), RF_ID_LENGTH);
}

void RfId::begin() {
  const bool first = read(0);
  const uint8_t firstGeneration = generation_;
  if (!read(1) || !first) return;
  if (static_cast<int8_t>(generation_ - firstGeneration) < 0) read(0);
  recordAt(place_ ^ 1).erase(0);
}

// Takes over what a place holds; changes nothing where that is no device address.
bool RfId::read(uint8_t place) {
  uint8_t stored[RF_ID_RECORD_LENGTH];
  if (!recordAt(place).begin(stored, 0)) return false;
  const Address address = Address::stored(stored);
  if (!address.isDevice()) return false;
  address_ = address;
  place_ = place;
  generation_ = stored[GENERATION_AT];
  return true;
}

bool RfId::set(const Address &address) {
  if (address == address_) return true;
  const uint8_t from = place_;
  const uint8_t to = from ^ 1;
  uint8_t stored[RF_ID_RECORD_LENGTH];
  address.store(stored);
  stored[GENERATION_AT] = static_cast<uint8_t>(generation_ + 1);
  return recordAt(to).write(stored) && read(to) && recordAt(from).erase(0);
}

}  // namespace javinolib
