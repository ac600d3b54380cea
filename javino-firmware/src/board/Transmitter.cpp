#include "Transmitter.h"

namespace javino {

const uint8_t Transmitter::MAX_UNREPORTED;

bool Transmitter::isFull() const {
  return count_ == config::TRANSMIT_QUEUE || static_cast<uint8_t>(nextNumber_ - nextReported_) >= MAX_UNREPORTED;
}

uint8_t Transmitter::commit(uint8_t length) {
  packets_[(first_ + count_) % config::TRANSMIT_QUEUE].length = length;
  count_++;
  return nextNumber_++;
}

void Transmitter::run() {
  if (isIdle()) return;
  if (onAir_) {
    onAir_ = false;
    nextSent_++;
  }
  if (count_ == 0) return;
  const Packet &packet = packets_[first_];
  onAir_ = radio_.send(packet.payload, packet.length);
  if (!onAir_) return;
  first_ = static_cast<uint8_t>((first_ + 1) % config::TRANSMIT_QUEUE);
  count_--;
}

bool Transmitter::isIdle() const { return onAir_ ? radio_.sending() : count_ == 0; }

}  // namespace javino
