#include "NonceSource.h"

#include "BoardState.h"

#include "../support/BigEndian.h"

namespace javinolib {

const uint32_t NonceSource::LAST_COUNTER;
const uint8_t NonceSource::MOST_ABOVE;

static const uint8_t COUNTER_AT = 3;

Status NonceSource::status() const {
  if (epoch_->status() != Status::OK) return epoch_->status();
  if (!retained::holds()) return Status::MEMORY_DAMAGED;
  return counter_ > LAST_COUNTER ? Status::NONCE_EXHAUSTED : Status::OK;
}

void NonceSource::take(uint8_t *nonce) {
  writeUint24(nonce, epoch_->value());
  writeUint24(nonce + COUNTER_AT, static_cast<Uint24>(counter_));
  counter_++;
}

void NonceSource::raiseEpoch(Uint24 epoch) {
  if (epoch <= epoch_->value()) return;
  epoch_->raise(epoch);
  counter_ = 0;
  if (retained::holds()) retained::beginEpoch(epoch);
}

bool NonceSource::raiseAbove(const uint8_t *floor, const uint8_t *nonce) {
  const uint32_t counter = readUint24(floor + COUNTER_AT);
  if (readUint24(floor) != epoch_->value() || counter > readUint24(nonce + COUNTER_AT) + MOST_ABOVE) return false;
  if (counter >= counter_) counter_ = counter + 1;
  return true;
}

}  // namespace javinolib
