#include "CapturedPackets.h"

#if JAVINO_LARGE

#include <string.h>

#include "../support/BigEndian.h"
#include "../support/Clock.h"

namespace javinolib {

void CapturedPackets::listen(bool on) {
  listens_ = on;
  told_ = records_.count();
  if (!on) forgetTold();
  told_ = 0;
}

void CapturedPackets::add(How how, const uint8_t *payload, uint8_t length) {
  uint8_t *const into = append(how, length);
  if (into) memcpy(into, payload, length);
}

// A packet whose count cannot be read has no known end: all that came is told.
void CapturedPackets::add(const RadioPacket &lost) {
  const uint8_t count = lost.count();
  uint8_t length = static_cast<uint8_t>(lost.symbols / 2);
  if (length != 0) length--;  // the count
  const uint8_t most =
      count == RadioPacket::NO_COUNT ? MAX_RADIO_PAYLOAD : static_cast<uint8_t>(count - linecode::PACKET_OVERHEAD);
  if (length > most) length = most;
  uint8_t *const into = append(DAMAGED, length);
  for (uint8_t i = 0; into && i < length; i++) into[i] = lost.readByte(static_cast<uint8_t>(i + 1));
}

ByteQueue::Record CapturedPackets::firstPending() const {
  ByteQueue::Record record = records_.first();
  for (uint8_t i = 0; i < told_; i++) record = records_.after(record);
  return record;
}

void CapturedPackets::forgetTold() {
  for (; told_ != 0; told_--) records_.remove(records_.first().bytes);
}

uint8_t *CapturedPackets::append(How how, uint8_t length) {
  if (!listens_) return nullptr;
  const uint16_t all = static_cast<uint16_t>(HEAD_LENGTH + length);
  if (!records_.fits(all)) {
    counters_->count(Counter::RADIO_OVERHEARD_DROPPED);
    return nullptr;
  }
  uint8_t *const record = records_.append(all);
  writeUint32(record, clock::millis());
  record[4] = how;
  return record + HEAD_LENGTH;
}

}  // namespace javinolib

#endif
