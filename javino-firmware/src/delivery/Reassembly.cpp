#include "Reassembly.h"

#include <string.h>

#include "Pieces.h"

namespace javino {

static const uint16_t EXPIRY_MILLIS = 5000;

bool PartialFrame::isWhole() const { return hasFirst() && have == pieces::all(pieces::count(length)); }

bool PartialFrame::add(uint8_t index, const uint8_t *piece, uint8_t pieceLength, uint16_t frameLength, uint16_t now) {
  const uint16_t at = static_cast<uint16_t>(index * PIECE_LENGTH);
  if (frameLength == 0 && pieceLength != PIECE_LENGTH) frameLength = static_cast<uint16_t>(at + pieceLength);
  if (frameLength == 0) frameLength = length;
  if (at + pieceLength > MAX_FRAME_LENGTH || frameLength > MAX_FRAME_LENGTH) return false;
  if (length != 0 && frameLength != length) return false;
  if (frameLength != 0 && !fitsWhole(index, pieceLength, frameLength)) return false;
  const uint8_t bit = static_cast<uint8_t>(1 << index);
  if ((have & bit) != 0) return memcmp(bytes + at, piece, pieceLength) == 0;
  length = frameLength;
  have |= bit;
  lastNew = now;
  memcpy(bytes + at, piece, pieceLength);
  return true;
}

// Whether a frame of this length has this piece, and those that are here. All of these are full where the length is only
// told now.
bool PartialFrame::fitsWhole(uint8_t index, uint8_t pieceLength, uint16_t frameLength) const {
  const uint8_t count = pieces::count(frameLength);
  if (count == 1 || index >= count || pieceLength != pieces::length(frameLength, index)) return false;
  if (length != 0) return true;
  const bool lastIsFull = pieces::length(frameLength, static_cast<uint8_t>(count - 1)) == PIECE_LENGTH;
  return (have & ~pieces::all(lastIsFull ? count : static_cast<uint8_t>(count - 1))) == 0;
}

Reassembly::Reassembly() { clear(); }

PartialFrame *Reassembly::find(const Address &origin, uint8_t id) {
  for (PartialFrame &frame : frames_) {
    if (!frame.isFree() && frame.id == id && frame.origin == origin) return &frame;
  }
  return nullptr;
}

PartialFrame *Reassembly::begin(const Address &origin, uint8_t id, bool hasFirst, bool &expired) {
  PartialFrame *place = nullptr;
  for (PartialFrame &frame : frames_) {
    if (frame.isFree() || (hasFirst && !frame.hasFirst() && place == nullptr)) place = &frame;
    if (frame.isFree()) break;
  }
  if (place == nullptr) return nullptr;
  expired = !place->isFree();
  place->have = 0;
  place->length = 0;
  place->origin = origin;
  place->id = id;
  return place;
}

uint8_t Reassembly::expire(uint16_t now) {
  uint8_t expired = 0;
  for (PartialFrame &frame : frames_) {
    if (frame.isFree() || static_cast<uint16_t>(now - frame.lastNew) < EXPIRY_MILLIS) continue;
    frame.have = 0;
    expired++;
  }
  return expired;
}

void Reassembly::clear() {
  for (PartialFrame &frame : frames_) frame.have = 0;
}

}  // namespace javino
