#include "CarrierSense.h"

#include "LineCode.h"
#include "Radio.h"

namespace javinolib {

namespace {

// The first edge is at the second bit: nine periods of two bits end at the twelfth. Pulses of random lengths do that
// about once in 100 000 edges where most edges are a bit apart, which is rare enough for a carrier of a few bits.
const uint8_t PERIODS_OF_TRAINING = 9;

// From here on it is no noise. Of two trainings that overlap so much is left to hear, whatever their distance.
const uint8_t PERIODS_OF_NO_NOISE = 14;

// From one edge in training until the count is there, where one edge was the last that was right: eleven bits are
// allowed for training to be taken up again, 24 for start symbol and count.
const uint16_t BITS_TO_COUNT = 35;

// Edges in pairs that are whole bits apart, one after the other: of a packet whose training was not heard. Two edges in
// noise are that by half, where they are two bits apart or more.
const uint8_t PERIODS_OF_PACKET = 13;
const uint8_t MAX_PERIOD_BITS = 8;
const uint16_t BITS_TO_NEXT_PERIODS = 24;

// High ones after silence, none of them shorter than a bit.
const uint8_t PULSES_AFTER_SILENCE = 3;

// All after training.
const uint16_t BITS_OF_LONGEST_PACKET =
    12 + 2 * linecode::BITS_PER_SYMBOL * (linecode::MAX_COUNT + linecode::TRAILER_LENGTH);

}  // namespace

CarrierSense::CarrierSense(uint16_t bitTicks) : bitTicks_(bitTicks) {}

void CarrierSense::addEdge(uint16_t now, bool level) {
  if (!level && !edgeIsOld_) addPulse(static_cast<uint16_t>(now - edge_));
  edgeIsOld_ = false;
  const uint16_t period = static_cast<uint16_t>(now - edgeBefore_);
  edgeBefore_ = edge_;
  edge_ = now;
  held_ = false;
  const uint8_t bits = wholeBits(period);
  if (bits == 2) {
    addTrainingPeriod();
  } else {
    training_ = 0;
  }
  if (bits >= 2) {
    addPeriod();
  } else {
    // One edge that is off does not end what is known to be there.
    periods_ = isHeard() ? periods_ / 2 : 0;
  }
}

// How many bits a period is long, 1…8; 0 where it is not a whole number of them.
uint8_t CarrierSense::wholeBits(uint16_t period) const {
  const uint16_t tolerance = bitTicks_ / 4;  // either way
  for (uint8_t bits = 1; bits <= MAX_PERIOD_BITS; bits++) {
    period = static_cast<uint16_t>(period - bitTicks_);
    if (static_cast<uint16_t>(period + tolerance) <= 2 * tolerance) return bits;
  }
  return 0;
}

void CarrierSense::addTrainingPeriod() {
  if (training_ < PERIODS_OF_NO_NOISE) training_++;
  if (training_ == PERIODS_OF_NO_NOISE) {
    bitsLeft_ = BITS_OF_LONGEST_PACKET;
  } else if (training_ >= PERIODS_OF_TRAINING) {
    expectAtLeast(BITS_TO_COUNT);
  }
}

void CarrierSense::addPeriod() {
  if (periods_ < PERIODS_OF_PACKET) periods_++;
  if (periods_ == PERIODS_OF_PACKET) expectAtLeast(BITS_TO_NEXT_PERIODS);
}

// A shorter pulse is noise, and so was then what seemed to be a carrier by its first pulses. It is much shorter: where a
// pulse follows a gap of a few ticks, as in collisions, the interrupt of the gap's end waits for that of its beginning,
// which has up to five bits to decode, and the pulse seems to begin a third of a bit later.
void CarrierSense::addPulse(uint16_t ticks) {
  if (!clean_) return;
  if (ticks < bitTicks_ / 2) {
    clean_ = false;
    if (pulses_ == PULSES_AFTER_SILENCE && training_ < PERIODS_OF_TRAINING) bitsLeft_ = 0;
  } else if (pulses_ != PULSES_AFTER_SILENCE && ++pulses_ == PULSES_AFTER_SILENCE) {
    bitsLeft_ = BITS_OF_LONGEST_PACKET;
  }
}

// For the time of the longest packet; then no packet holds it.
void CarrierSense::addHold() {
  edgeIsOld_ = true;
  if (!clean_ || held_ || bitsLeft_ != 0) return;
  held_ = true;
  bitsLeft_ = BITS_OF_LONGEST_PACKET;
}

void CarrierSense::expectAtLeast(uint16_t bits) {
  if (bitsLeft_ < bits) bitsLeft_ = bits;
}

void CarrierSense::expect(uint16_t bits) {
  trained_ = bitsLeft_ != 0;
  bitsLeft_ = bits;
  training_ = 0;
  pulses_ = 0;
  held_ = false;
  edgeIsOld_ = true;
}

void CarrierSense::doubt() {
  if (!trained_) reset();
}

void CarrierSense::reset() {
  bitsLeft_ = 0;
  training_ = 0;
  periods_ = 0;
  pulses_ = 0;
}

}  // namespace javinolib
