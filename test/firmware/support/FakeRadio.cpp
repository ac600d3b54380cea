#include "FakeRadio.h"

#include <stdexcept>

bool FakeRadio::send(const uint8_t *payload, uint8_t length) {
  if (length == 0 || length > javino::MAX_RADIO_PAYLOAD) throw std::logic_error("no radio packet has this length");
  if (onAir_ || refuses) return false;
  sent.push_back(Bytes(payload, payload + length));
  onAir_ = true;
  return true;
}

uint8_t *FakeRadio::receive(uint8_t &length) {
  if (in_.empty()) return nullptr;
  length = static_cast<uint8_t>(in_.front().size());
  return in_.front().data();
}

void FakeRadio::finishSending() {
  onAir_ = false;
  counts.sent++;
}
