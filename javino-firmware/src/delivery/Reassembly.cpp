#include "Reassembly.h"

#include <string.h>

namespace javinolib {

static const uint8_t MOST_REFUSALS = 4;

namespace {

uint16_t lengthIn(const uint8_t *first) {
  Frame whole;
  Frame::parseHeader(first, whole);
  return static_cast<uint16_t>(HEADER_LENGTH + whole.length);
}

void exchange(uint8_t *one, uint8_t *other, uint16_t length) {
  for (; length != 0; length--) {
    const uint8_t kept = *one;
    *one++ = *other;
    *other++ = kept;
  }
}

}  // namespace

void PartialFrame::begin(const Address &from, uint8_t number, uint8_t longest) {
  have_ = 0;
  refusals_ = 0;
  doubted_ = 0;
  origin = from;
  id = number;
  longest_ = longest;
  for (Aside &aside : aside_) aside.length = 0;
}

uint16_t PartialFrame::length() const { return lengthIn(bytes_); }

uint8_t PartialFrame::have() const {
  if (!hasFirst()) return 0;
  const uint16_t whole = length();
  uint8_t have = 0;
  uint8_t bit = 1;
  for (uint8_t index = 0; index < MAX_FRAGMENTS; index++, bit = static_cast<uint8_t>(bit << 1)) {
    if ((have_ & bit) != 0 && isFragmentOf(whole, index, lengths_[index])) have |= bit;
  }
  return have;
}

bool PartialFrame::isWhole() const {
  return hasFirst() && have() == fragments::all(fragments::count(length(), longest_));
}

// Whether a frame of this length, which has to be cut, has this fragment.
bool PartialFrame::isFragmentOf(uint16_t frameLength, uint8_t index, uint8_t fragmentLength) const {
  const uint16_t from = static_cast<uint16_t>(index * longest_);
  return from < frameLength && fragmentLength == fragments::length(frameLength, index, longest_);
}

bool PartialFrame::fits(uint8_t index, uint8_t fragmentLength) const {
  if (fragmentLength > longest_ || static_cast<uint16_t>(index * longest_ + fragmentLength) > MAX_FRAME_LENGTH)
    return false;
  if (index == 0 || !hasFirst() || isFragmentOf(length(), index, fragmentLength)) return true;
  return aside_[0].length != 0 && isFragmentOf(lengthIn(aside_[0].bytes), index, fragmentLength);
}

bool PartialFrame::add(uint8_t index, const uint8_t *fragment, uint8_t fragmentLength, uint16_t now) {
  if (!fits(index, fragmentLength)) return false;
  const uint8_t bit = fragments::bitOf(index);
  uint8_t *place = at(index);
  last_ = index;
  doubted_ = static_cast<uint8_t>(doubted_ & ~bit);
  if ((have_ & bit) != 0) {
    if (lengths_[index] == fragmentLength && memcmp(place, fragment, fragmentLength) == 0) return true;
    Aside &aside = asideOf(index);
    aside.index = index;
    aside.length = lengths_[index];
    memcpy(aside.bytes, place, aside.length);
  }
  have_ |= bit;
  lastNew = now;
  lengths_[index] = fragmentLength;
  memcpy(place, fragment, fragmentLength);
  return true;
}

bool PartialFrame::choose(uint8_t turn) { return swap(asideOf((turn & 1) == 0)); }

bool PartialFrame::swap(Aside &aside) {
  if (aside.length == 0) return false;
  uint8_t *place = at(aside.index);
  const uint16_t left = static_cast<uint16_t>(bytes_ + MAX_FRAME_LENGTH - place);
  exchange(place, aside.bytes, left < FRAGMENT_LENGTH ? left : FRAGMENT_LENGTH);
  const uint8_t length = lengths_[aside.index];
  lengths_[aside.index] = aside.length;
  aside.length = length;
  return true;
}

void PartialFrame::refuse() {
  const bool hasOtherFirst = aside_[0].length != 0;
  Aside &aside = asideOf(!hasOtherFirst);
  if ((hasOtherFirst || aside.index == last_) && swap(aside)) {
    aside.length = 0;
    return;
  }
  refusals_++;
  if (refusals_ == MOST_REFUSALS) have_ = 0;
  doubted_ = fragments::bitOf(last_);
}

PartialFrame *Reassembly::find(const Address &origin, uint8_t id) {
  for (PartialFrame *frame = frames_; frame != end(); frame++) {
    if (!frame->isFree() && frame->id == id && frame->origin == origin) return frame;
  }
  return nullptr;
}

PartialFrame *Reassembly::begin(const Address &origin, uint8_t id, uint8_t longest, bool hasFirst, bool &expired) {
  PartialFrame *place = nullptr;
  for (PartialFrame *frame = frames_; frame != end(); frame++) {
    const bool fits = frame->isFree() && findRoom(*frame);
    if (fits || (hasFirst && !frame->isFree() && !frame->hasFirst() && place == nullptr)) place = frame;
    if (fits) break;
  }
  if (place == nullptr) return nullptr;
  expired = !place->isFree();
  place->begin(origin, id, longest);
  return place;
}

// In the inbox only while the own room is taken.
bool Reassembly::findRoom(PartialFrame &frame) {
  if (frame.bytes() == nullptr) frame.setBytes(lent_ || inRoom().bytes() == room_.frame ? inbox_->lend() : room_.frame);
  return frame.bytes() != nullptr;
}

// A message in the inbox has to go to make room there: it changes places with a message that goes.
uint8_t *Reassembly::release(PartialFrame &frame) {
  PartialFrame &other = frames_[&frame == frames_ ? 1 : 0];
  uint8_t *bytes = frame.bytes();
  frame.clear();
  frame.setBytes(nullptr);
  if (bytes == room_.frame && other.bytes() != nullptr) {
    bytes = other.bytes();
    exchange(room_.frame, bytes, MAX_FRAME_LENGTH);
    other.setBytes(room_.frame);
  }
  if (bytes != nullptr && bytes != room_.frame) inbox_->takeBack();
  return bytes;
}

uint8_t Reassembly::expire(uint16_t now, uint16_t after) {
  uint8_t expired = 0;
  for (PartialFrame *frame = frames_; frame != end(); frame++) {
    if (!frame->isFree()) {
      if (static_cast<uint16_t>(now - frame->lastNew) < after) continue;
      expired++;
    }
    release(*frame);
  }
  return expired;
}

void Reassembly::clear() {
  for (PartialFrame *frame = frames_; frame != end(); frame++) release(*frame);
}

BoardsForwarding::Memory *Reassembly::lend() {
  PartialFrame &frame = inRoom();
  if (frame.bytes() == room_.frame) {
    frame.clear();
    frame.setBytes(nullptr);
  }
  lent_ = true;
  memset(static_cast<void *>(&room_), 0, sizeof room_);
  return &room_.relay;
}

}  // namespace javinolib
