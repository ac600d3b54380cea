#include "Distances.h"

#include <string.h>

#include "../framing/Address.h"
#include "../support/Crc16.h"

namespace javinolib {

const uint8_t Distances::NONE;
const uint8_t Distances::FIRST;
const uint8_t Distances::AFTER_RESERVE;
const uint8_t Distances::MOST;

uint16_t Distances::numberOf(const uint8_t *text) {
  Crc16 crc;
  crc.add(text, Address::TEXT_LENGTH);
  return crc.value();
}

uint8_t Distances::find(uint16_t address) const {
  uint8_t i = 0;
  while (i < count_ && entries_[i].address != address) i++;
  return i;
}

uint8_t Distances::of(uint16_t address) const {
  const uint8_t i = find(address);
  return i < count_ ? entries_[i].known : FIRST;
}

void Distances::set(uint16_t address, uint8_t known) {
  uint8_t i = find(address);
  if (i == count_) {
    if (count_ < CAPACITY) count_++;
    i = static_cast<uint8_t>(count_ - 1);
  }
  memmove(entries_ + 1, entries_, i * sizeof(Entry));
  entries_[0] = {address, known};
}

void Distances::setScore(uint16_t address, uint8_t score) {
  set(address, static_cast<uint8_t>((of(address) & ~SCORE_MASK) | score));
}

// A greater distance may be that of a detour.
void Distances::heard(uint16_t address, uint8_t hops) {
  const uint8_t known = of(address);
  const uint8_t distance = distanceIn(known);
  const uint8_t heard = static_cast<uint8_t>((hops + 1) % HOPS_MODULUS + 1);
  const uint8_t more = static_cast<uint8_t>((heard + HOPS_MODULUS - distance) % HOPS_MODULUS);
  const uint8_t farther = static_cast<uint8_t>(known >> FARTHER_SHIFT);
  if (distance != 0 && more != 0 && more != HOPS_MODULUS - 1 && farther < MOST_FARTHER) {
    set(address, static_cast<uint8_t>(known + (1 << FARTHER_SHIFT)));
  } else {
    set(address, static_cast<uint8_t>((known & SCORE_MASK) | heard << DISTANCE_SHIFT));
  }
}

}  // namespace javinolib
