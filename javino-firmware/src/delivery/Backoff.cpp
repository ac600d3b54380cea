#include "Backoff.h"

namespace javino {

static const uint8_t LONG_QUIET = 15;
static const uint8_t FIRST_SLOTS = 6;
static const uint8_t FIRST_MASK = 15;
static const uint8_t LAST_DOUBLING = 1;  // 0…31: who retries must not wait much longer than who is new, or would starve

void Backoff::begin(uint8_t attempt, uint8_t quietSlots, Random &random) {
  const uint8_t doublings = attempt < LAST_DOUBLING ? attempt : LAST_DOUBLING;
  const bool atOnce = attempt == 0 && quietSlots >= LONG_QUIET;
  counted_ = quietSlots < FIRST_SLOTS ? FIRST_SLOTS : quietSlots;
  left_ = atOnce ? 0 : static_cast<uint8_t>(random.next(static_cast<uint16_t>((FIRST_MASK + 1) << doublings) - 1u));
}

bool Backoff::isOver(uint8_t quietSlots) {
  if (quietSlots < FIRST_SLOTS) {
    counted_ = FIRST_SLOTS;
    return false;
  }
  for (; counted_ < quietSlots && left_ != 0; counted_++) left_--;
  return left_ == 0;
}

}  // namespace javino
