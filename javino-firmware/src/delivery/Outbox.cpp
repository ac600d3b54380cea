#include "Outbox.h"

#include <string.h>

#include "../secure/Envelope.h"

namespace javino {

const uint8_t Outcomes::MAX_UNREPORTED;

uint8_t Outbox::addPlain(const Frame &frame) {
  return add(frame, HEADER_LENGTH, static_cast<uint16_t>(HEADER_LENGTH + frame.length));
}

uint8_t Outbox::addUnsealed(const Frame &frame) {
  return add(frame, Envelope::CONTENT_AT, static_cast<uint16_t>(Envelope::MIN_FRAME_LENGTH + frame.length));
}

uint8_t Outbox::add(const Frame &frame, uint8_t contentAt, uint16_t length) {
  uint8_t *record = records_.append(length);
  Frame::writeHeader(record, frame.destination, frame.origin, static_cast<uint16_t>(length - HEADER_LENGTH));
  memcpy(record + contentAt, frame.message, frame.length);
  return outcomes_.open();
}

void Outbox::close(Outcome outcome) {
  outcomes_.close(outcome);
  records_.removeFirst();
}

}  // namespace javino
