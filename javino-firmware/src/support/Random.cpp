#include "Random.h"

#include "Crc16.h"

namespace javinolib {

void Random::seed(Uint24 id, Uint24 epoch) {
  uint8_t bytes[3 + 3];
  writeUint24(bytes, id);
  writeUint24(bytes + 3, epoch);
  Crc16 crc;
  crc.add(bytes, sizeof bytes);
  state_ = crc.value() == 0 ? 1 : crc.value();
}

uint16_t Random::next(uint16_t mask) {
  state_ = static_cast<uint16_t>(state_ ^ state_ << 7);
  state_ = static_cast<uint16_t>(state_ ^ state_ >> 9);
  state_ = static_cast<uint16_t>(state_ ^ state_ << 8);
  return state_ & mask;
}

}  // namespace javinolib
