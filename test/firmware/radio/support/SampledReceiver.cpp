#include "SampledReceiver.h"

namespace {

const int SAMPLES_PER_BIT = 8;
const int RAMP_LENGTH = 160;
const int RAMP_STEP = 20;
const int RAMP_STEP_EARLY = 11;
const int RAMP_STEP_LATE = 29;
const int ONES_FOR_ONE = 5;
const unsigned START = 0xB38;

// The decoding direction of SPEC 6's table, as a switch instead of a search.
int nibble(unsigned symbol) {
  switch (symbol) {
    case 0x0D: return 0;
    case 0x0E: return 1;
    case 0x13: return 2;
    case 0x15: return 3;
    case 0x16: return 4;
    case 0x19: return 5;
    case 0x1A: return 6;
    case 0x1C: return 7;
    case 0x23: return 8;
    case 0x25: return 9;
    case 0x26: return 10;
    case 0x29: return 11;
    case 0x2A: return 12;
    case 0x2C: return 13;
    case 0x32: return 14;
    case 0x34: return 15;
    default: return 0;  // VirtualWire leaves it to the CRC
  }
}

}  // namespace

std::vector<Bytes> SampledReceiver::receive(const AirLine &line, double bitTicks) {
  SampledReceiver receiver;
  const double step = bitTicks / SAMPLES_PER_BIT;
  double until = 0;
  double at = step / 3;  // anywhere
  for (const AirLine::Run &run : line.runs()) {
    until += run.ticks;
    for (; at < until; at += step) receiver.sample(run.level);
  }
  for (int i = 0; i < 2 * SAMPLES_PER_BIT; i++) receiver.sample(false);
  return receiver.payloads_;
}

void SampledReceiver::sample(bool level) {
  if (level) ones_++;
  if (level != last_) {
    ramp_ += ramp_ < RAMP_LENGTH / 2 ? RAMP_STEP_EARLY : RAMP_STEP_LATE;
    last_ = level;
  } else {
    ramp_ += RAMP_STEP;
  }
  if (ramp_ < RAMP_LENGTH) return;
  ramp_ -= RAMP_LENGTH;
  addBit(ones_ >= ONES_FOR_ONE);
  ones_ = 0;
}

void SampledReceiver::addBit(bool bit) {
  bits_ = bits_ >> 1 | (bit ? 0x800 : 0);
  if (!active_) {
    if (bits_ == START) {
      active_ = true;
      bitCount_ = 0;
      packet_.clear();
    }
    return;
  }
  if (++bitCount_ < 12) return;
  bitCount_ = 0;
  packet_.push_back(static_cast<uint8_t>(nibble(bits_ & 0x3F) << 4 | nibble(bits_ >> 6)));
  const size_t count = packet_[0];
  if (count < 4 || count > 80) {
    active_ = false;
    return;
  }
  if (packet_.size() < count) return;
  active_ = false;
  const Bytes payload(packet_.begin() + 1, packet_.end() - 2);
  if (packet_ == reference::packetOf(payload)) payloads_.push_back(payload);
}
