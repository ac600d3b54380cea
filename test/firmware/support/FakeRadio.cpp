#include "FakeRadio.h"

#include <algorithm>
#include <stdexcept>

bool FakeRadio::send(const uint8_t *payload, uint8_t length) {
  if (length == 0 || length > javino::MAX_RADIO_PAYLOAD) throw std::logic_error("no radio packet has this length");
  if (onAir_ || refuses) return false;
  sent.push_back(Bytes(payload, payload + length));
  onAir_ = true;
  return true;
}

uint8_t FakeRadio::receive(uint8_t *payload) {
  if (in_.empty()) return 0;
  const Bytes packet = in_.front();
  in_.pop_front();
  std::copy(packet.begin(), packet.end(), payload);
  return static_cast<uint8_t>(packet.size());
}

void FakeRadio::finishSending() {
  onAir_ = false;
  counts.sent++;
}
