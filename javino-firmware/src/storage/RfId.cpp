#include "RfId.h"

#include "EepromLayout.h"

namespace javinolib {

JAVINO_NOINLINE static uint16_t placeAt(uint8_t place) {
  return static_cast<uint16_t>(RF_ID_AT + place * RF_ID_RECORD_LENGTH);
}

static EepromRecord recordAt(uint8_t place) { return EepromRecord(placeAt(place), RF_ID_LENGTH); }

void RfId::begin() {
  for (uint8_t place = 0; place < RF_ID_PLACES; place++) {
    Stored found;
    if (!recordAt(place).begin(found.record(), 0) || !found.address.isDevice()) continue;
    if (isSet() && static_cast<int8_t>(found.generation - id_.generation) < 0) continue;
    id_ = found;
    place_ = place;
  }
  if (isSet()) recordAt(place_ ^ 1).erase(0);
}

bool RfId::set(const Address &address) {
  if (address == this->address()) return true;
  Stored next;
  next.address = address;
  next.generation = static_cast<uint8_t>(id_.generation + 1);
  if (!recordAt(place_ ^ 1).write(next.record())) return false;
  id_ = next;
  place_ ^= 1;
  return recordAt(place_ ^ 1).erase(0);
}

}  // namespace javinolib
