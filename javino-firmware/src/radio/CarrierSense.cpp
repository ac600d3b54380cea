#include "CarrierSense.h"

#include "LineCode.h"
#include "Radio.h"

namespace javino {

namespace {

// The first edge is at the second bit: nine periods of two bits end at the twelfth. Pulses of random lengths do that
// about once in 100 000 edges where most edges are a bit apart, which is rare enough for a carrier of a few bits.
const uint8_t PERIODS_OF_TRAINING = 9;

// From here on it is no noise. Of two trainings that overlap so much is left to hear, whatever their distance.
const uint8_t PERIODS_OF_NO_NOISE = 14;

// From one edge in training until the count is there, where one edge was the last that was right: eleven bits are
// allowed for training to be taken up again, 24 for start symbol and count.
const uint16_t BITS_TO_COUNT = 35;

// All after training.
const uint16_t BITS_OF_LONGEST_PACKET =
    12 + 2 * linecode::BITS_PER_SYMBOL * (MAX_RADIO_PAYLOAD + linecode::PACKET_OVERHEAD);

}  // namespace

CarrierSense::CarrierSense(uint16_t bitTicks)
    : periodTicks_(2 * bitTicks),
      toleranceTicks_(bitTicks / 4),
      edge_(0),
      edgeBefore_(0),
      periods_(0),
      trained_(false),
      bitsLeft_(0) {}

void CarrierSense::addEdge(uint16_t now) {
  const uint16_t period = static_cast<uint16_t>(now - edgeBefore_);
  edgeBefore_ = edge_;
  edge_ = now;
  const uint16_t aboveLeast = static_cast<uint16_t>(period - (periodTicks_ - toleranceTicks_));
  if (aboveLeast > 2 * toleranceTicks_) {
    periods_ = 0;
    return;
  }
  if (periods_ < PERIODS_OF_NO_NOISE) periods_++;
  if (periods_ == PERIODS_OF_NO_NOISE) {
    bitsLeft_ = BITS_OF_LONGEST_PACKET;
  } else if (periods_ >= PERIODS_OF_TRAINING && bitsLeft_ < BITS_TO_COUNT) {
    bitsLeft_ = BITS_TO_COUNT;
  }
}

void CarrierSense::expect(uint16_t bits) {
  trained_ = bitsLeft_ != 0;
  bitsLeft_ = bits;
  periods_ = 0;
}

void CarrierSense::doubt() {
  if (!trained_) reset();
}

void CarrierSense::reset() {
  bitsLeft_ = 0;
  periods_ = 0;
}

}  // namespace javino
