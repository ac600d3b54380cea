#include "Counters.h"

namespace javino {

const uint8_t Counters::COUNT;

void Counters::count(Counter counter) {
  uint32_t &value = values_[indexOf(counter)];
  if (value != UINT32_MAX) value++;
}

}  // namespace javino
