#include "AirtimeLimit.h"

#include "../framing/Address.h"
#include "../storage/Retained.h"
#include "../support/Clock.h"
#include "Fragments.h"

namespace javinolib {

// The level is in 1/800 ms of airtime, so that each number below is whole. Of an hour's P % it holds an eighth, and fills with
// the other seven within an hour: then no hour has more than P %.
static const uint32_t UNITS_A_MILLI = 800;
static const uint32_t CAPACITY = 36000 / 8 * UNITS_A_MILLI;  // for each percent
static const uint8_t FILL = 7;                               // for each percent, in a millisecond
static const uint32_t MILLIS_TO_FILL = CAPACITY / FILL + 1;

static const uint32_t GUARD = 0xCA9AA17E;

// Digits of a fragment's index that the first one has (SPEC 7.1).
static const uint8_t FIRST_DIGIT = 'A';
static const uint8_t FIRST_DIGIT_WANTS_ANSWER = 'I';

uint32_t AirtimeLimit::capacity() const { return CAPACITY * percent_; }

// One millisecond more, since drivers round down.
uint32_t AirtimeLimit::costOf(uint8_t length) const { return (radio_.airtimeMillis(length) + 1ul) * UNITS_A_MILLI; }

// What a packet is to leave: acknowledgements and what goes on with a message may take all. A receiver forgets the fragments
// of a message whose next one waits for long: the first is sent once all have their airtime.
uint32_t AirtimeLimit::reserveFrom(const uint8_t *payload, uint32_t cost) const {
  const uint8_t *path = radio_.sentPath();
  if (path != nullptr && *path % HOPS_MODULUS != 0) return capacity() / 4;
  if (payload[0] != '+') return capacity() / 8;
  const bool isFirst = payload[1] == 'F' && (payload[3] == FIRST_DIGIT || payload[3] == FIRST_DIGIT_WANTS_ANSWER);
  return isFirst ? capacity() / 8 + (MAX_FRAGMENTS - 1) * cost : 0;
}

uint32_t AirtimeLimit::level() const {
  const uint32_t now = clock::millis();
  uint32_t passed = now - lookedAt_;
  if (passed > MILLIS_TO_FILL) passed = MILLIS_TO_FILL;
  lookedAt_ = now;
  const retained::Airtime &kept = retained::airtime();
  uint32_t level = passed * (FILL * percent_);
  if (kept.check == (kept.level ^ GUARD ^ percent_)) level += kept.level;
  if (level > capacity()) level = capacity();
  keep(level);
  return level;
}

// A reset in between leaves a wrong check: all is spent.
void AirtimeLimit::keep(uint32_t level) const {
  retained::Airtime &kept = retained::airtime();
  kept.level = level;
  kept.check = level ^ GUARD ^ percent_;
}

bool AirtimeLimit::send(const uint8_t *payload, uint8_t length) {
  const uint32_t cost = costOf(static_cast<uint8_t>(length + follows_));
  const uint32_t before = level();
  const bool isEnough = before >= cost + reserveFrom(payload, cost) || (before == capacity() && before >= cost);
  if (!isEnough || !radio_.send(payload, length)) return false;
  keep(before - cost);
  return true;
}

void AirtimeLimit::counters(RadioCounters &into) const {
  radio_.counters(into);
  uint32_t needed = capacity() / 8 + costOf(radio_.longestPayload());
  if (needed > capacity()) needed = capacity();
  const uint32_t before = level();
  const uint32_t inASecond = 1000ul * FILL * percent_;
  into.airtimeWait = before >= needed ? 0 : static_cast<config::Count>((needed - before + inASecond - 1) / inASecond);
}

}  // namespace javinolib
