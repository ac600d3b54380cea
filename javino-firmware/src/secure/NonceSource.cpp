#include "NonceSource.h"

#include "../support/BigEndian.h"

namespace javino {

const uint32_t NonceSource::LAST_COUNTER;

void NonceSource::take(uint8_t *nonce) {
  writeUint24(nonce, epoch_.value());
  writeUint24(nonce + 3, counter_);
  counter_++;
}

}  // namespace javino
