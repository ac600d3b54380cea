#include "Outbox.h"

#include <string.h>

#include "../secure/Envelope.h"

namespace javinolib {

const uint8_t Outcomes::MAX_UNREPORTED;

// The most of the 256 numbers between the oldest that has not ended and the newest one: the others keep those apart that have
// ended.
static const uint8_t MAX_SPAN = 255 - Outcomes::MAX_UNREPORTED;

bool Outbox::fits(Length frameLength) const {
  const uint8_t count = records_.count();
  if (outcomes_.count() + count >= Outcomes::MAX_UNREPORTED || !records_.fits(frameLength + 1)) return false;
  return config::PARTNERS == 1 || count == 0 || static_cast<uint8_t>(nextNumber_ - numberOf(first())) < MAX_SPAN;
}

uint8_t Outbox::addPlain(const Frame &frame) {
  return add(frame, HEADER_LENGTH, static_cast<Length>(HEADER_LENGTH + frame.length));
}

uint8_t Outbox::addUnsealed(const Frame &frame) {
  return add(frame, Envelope::CONTENT_AT, static_cast<Length>(Envelope::MIN_FRAME_LENGTH + frame.length));
}

uint8_t Outbox::add(const Frame &frame, uint8_t contentAt, Length length) {
  uint8_t *record = records_.append(length + 1);
  Frame::writeHeader(record, frame.destination, frame.origin, static_cast<Length>(length - HEADER_LENGTH));
  memcpy(record + contentAt, frame.message, frame.length);
  record[length] = nextNumber_;
  return nextNumber_++;
}

ByteQueue::Record Outbox::find(uint8_t number) const {
  ByteQueue::Record record = first();
  while (config::PARTNERS != 1 && numberOf(record) != number) record = after(record);
  record.length--;
  return record;
}

bool Outbox::hasFor(const Address &destination) const {
  for (ByteQueue::Record record = first(); record.bytes != nullptr; record = after(record)) {
    Address to;
    Address::parse(record.bytes, to);
    if (to == destination) return true;
  }
  return false;
}

void Outbox::close(uint8_t number, Outcome outcome) {
  outcomes_.add(number, outcome);
  records_.remove(find(number).bytes);
}

}  // namespace javinolib
