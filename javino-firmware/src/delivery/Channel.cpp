#include "Channel.h"

#include "../support/Clock.h"

namespace javino {

// A carrier is heard from its twelfth bit on, and seen by the loop within 1 ms: another that begins a slot later is
// put off.
static const uint16_t SLOT_BITS = 16;
static const uint16_t PACKET_BITS = 84;  // of a packet without payload (SPEC 6)
static const uint16_t BITS_A_BYTE = 12;

void Channel::begin() {
  slotMillis_ = static_cast<uint8_t>((SLOT_BITS * 1000u + radio_.bitRate() - 1) / radio_.bitRate());
}

void Channel::update() {
  const uint16_t now = static_cast<uint16_t>(clock::millis());
  const bool wasBusy = busy_;
  carrier_ = radio_.carrier();
  busy_ = carrier_ || radio_.sending();
  const uint16_t elapsed = static_cast<uint16_t>(now - lookedAt_);
  lookedAt_ = now;
  quietMillis_ = 0;
  if (busy_ || wasBusy) {
    quietSlots_ = 0;
    slotSince_ = now;
    return;
  }
  quietMillis_ = static_cast<uint8_t>(elapsed > UINT8_MAX ? UINT8_MAX : elapsed);
  for (; static_cast<uint16_t>(now - slotSince_) >= slotMillis_;
       slotSince_ = static_cast<uint16_t>(slotSince_ + slotMillis_)) {
    if (quietSlots_ != UINT8_MAX) quietSlots_++;
  }
}

bool Channel::send(const uint8_t *payload, uint8_t length) {
  if (!radio_.send(payload, length)) return false;
  busy_ = true;
  quietSlots_ = 0;
  return true;
}

uint16_t Channel::airtimeMillis(uint8_t length) const {
  return static_cast<uint16_t>((PACKET_BITS + BITS_A_BYTE * length) * 1000ul / radio_.bitRate());
}

}  // namespace javino
