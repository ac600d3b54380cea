#include "Retries.h"

#include "../Config.h"

namespace javinolib {

static const uint8_t MAX_ATTEMPTS = 8;
static const uint8_t LATE_ATTEMPT = 2;
static const uint8_t LATE_ROUNDS = 3;
static const uint8_t MOST_PASSED = 32;
static const uint8_t PATIENCE_MILLIS = 150;

bool Retries::failed() { return ++attempts_ == MAX_ATTEMPTS; }

bool Retries::sent(bool isMulticast, bool isRelayed) {
  const uint8_t sends = isMulticast                                 ? config::MULTICAST_SENDS
                        : config::BROADCAST_SENDS != 1 && isRelayed ? 1
                                                                    : config::BROADCAST_SENDS;
  return ++attempts_ == sends;
}

uint8_t Retries::next(uint8_t arrived, uint8_t asked) const { return (arrived & attempts_ & 1) != 0 ? asked : 1; }

uint8_t Retries::rounds(bool isWhole) const {
  return static_cast<uint8_t>(isWhole && attempts_ >= LATE_ATTEMPT ? LATE_ROUNDS : 0);
}

bool Retries::isFirst() const { return passed_ == MOST_PASSED; }

void Patience::begin(uint8_t rounds) {
  millis_ = PATIENCE_MILLIS;
  rounds_ = rounds;
}

bool Patience::isOver(uint8_t quietMillis) {
  millis_ = static_cast<uint8_t>(millis_ > quietMillis ? millis_ - quietMillis : 0);
  if (millis_ != 0) return false;
  millis_ = PATIENCE_MILLIS;
  return rounds_-- == 0;
}

}  // namespace javinolib
