#include "Mender.h"

#include <string.h>

#include "../support/Crc16.h"

namespace javino {

const uint8_t Mender::NONE;
const uint8_t Mender::MOST_UNDECIDED;

namespace {

// Two copies differ in 6 % of their bits where 3 % of all bits are wrong; two packets of one sender, in half of those that
// nonce, content and tag take, which is a sixth of the shortest.
const uint8_t LIKE_PART = 8;

// Of 24 bits. Two copies differ in one or two.
const uint8_t MOST_OF_CRC = 5;
const uint8_t CRC_SYMBOLS = 4;

// Shorter ones are acknowledgements, which their sender knows beforehand.
const uint8_t LEAST_KEPT = 30;

uint16_t bitOf(uint8_t nibble) { return static_cast<uint16_t>(1 << nibble); }

uint8_t firstOf(uint16_t nibbles) {
  uint8_t nibble = 0;
  for (; (nibbles & 1) == 0; nibbles >>= 1) nibble++;
  return nibble;
}

bool isOne(uint16_t nibbles) { return (nibbles & (nibbles - 1)) == 0; }

// A nibble where it lies in a byte.
uint8_t placed(uint8_t nibble, uint8_t index) { return index % 2 == 0 ? static_cast<uint8_t>(nibble << 4) : nibble; }

}  // namespace

Mender::Progress Mender::step(RadioPacket &packet) {
  if (progress_ != PENDING) return progress_;
  packet_ = &packet;
  progress_ = work(packet);
  if (progress_ != PENDING) phase_ = Phase::LOOKING;
  return progress_;
}

Mender::Progress Mender::work(RadioPacket &packet) {
  switch (phase_) {
    case Phase::LOOKING: return look(packet);
    case Phase::COMPARING: return compare(packet);
    case Phase::CHOOSING: return choose(packet);
    case Phase::CORRECTING: return correct(packet);
  }
  return LOST;
}

// The end of a good packet is not waited for.
Mender::Progress Mender::look(RadioPacket &packet) {
  like_ = NONE;
  mended_ = false;
  doubtful_ = false;
  hasParity_ = false;
  if (packet.isIntact()) {
    packet.makeBytes(packet.count());
    return WHOLE;
  }
  if (config::PARITY && packet.open) return PENDING;
  if (!config::MENDING && packet.count() == RadioPacket::NO_COUNT) return LOST;
  mended_ = true;
  doubtful_ = true;
  next_ = 0;
  phase_ = Phase::COMPARING;
  return PENDING;
}

#if JAVINO_DAMAGED_COPIES

// Looks at one copy at a time.
Mender::Progress Mender::compare(RadioPacket &packet) {
  const RadioPacket &copy = copies_[next_];
  if (isLike(packet, copy)) {
    like_ = next_;
  } else if (++next_ < config::DAMAGED_COPIES) {
    return PENDING;
  }
  if (like_ != NONE && copy.areBytes) {
    memcpy(packet.room, copy.room, sizeof packet.room);
    packet.areBytes = true;
    return WHOLE;
  }
  next_ = linecode::MIN_COUNT;
  phase_ = Phase::CHOOSING;
  return PENDING;
}

// A piece that asks and the same one that does not differ in one digit, and in the CRC: they are two packets.
bool Mender::isLike(const RadioPacket &packet, const RadioPacket &copy) {
  if (copy.symbols == 0) return false;
  const uint8_t count = packet.count();
  const uint8_t other = copy.count();
  if (count != RadioPacket::NO_COUNT && other != RadioPacket::NO_COUNT && count != other) return false;
  const uint8_t known = count != RadioPacket::NO_COUNT ? count : other;
  uint8_t symbols = copy.symbols < packet.symbols ? copy.symbols : packet.symbols;
  if (known != RadioPacket::NO_COUNT) {
    if (2 * known > symbols) return false;
    symbols = static_cast<uint8_t>(2 * known);
  }
  uint8_t left = static_cast<uint8_t>(symbols * (linecode::BITS_PER_SYMBOL / 2) / (LIKE_PART / 2));
  uint8_t leftOfCrc = MOST_OF_CRC;
  for (uint8_t i = 0; i < symbols; i++) {
    const uint8_t differ = linecode::onesOf(packet.symbol(i) ^ copy.symbol(i));
    if (differ > left) return false;
    left = static_cast<uint8_t>(left - differ);
    if (known == RadioPacket::NO_COUNT || i + CRC_SYMBOLS < symbols) continue;
    if (differ > leftOfCrc) return false;
    leftOfCrc = static_cast<uint8_t>(leftOfCrc - differ);
  }
  return true;
}

const RadioPacket *Mender::copy() const { return like_ != NONE ? copies_ + like_ : nullptr; }

#else

Mender::Progress Mender::compare(RadioPacket &) {
  next_ = linecode::MIN_COUNT;
  phase_ = Phase::CHOOSING;
  return PENDING;
}

const RadioPacket *Mender::copy() const { return nullptr; }

#endif

// Whether this is the packet's count; where that came with a wrong bit, whether it may be.
bool Mender::mayHaveCount(const RadioPacket &packet, uint8_t count) const {
  const uint8_t known = packet.count();
  if (known != RadioPacket::NO_COUNT) return count == known;
  return linecode::onesOf(packet.symbol(0) ^ linecode::symbolOf(static_cast<uint8_t>(count >> 4))) <= 1 &&
         linecode::onesOf(packet.symbol(1) ^ linecode::symbolOf(count)) <= 1;
}

Mender::Progress Mender::choose(RadioPacket &packet) {
  for (; next_ <= linecode::MAX_COUNT && 2 * next_ <= packet.symbols; next_++) {
    if (!mayHaveCount(packet, next_) || (copy() && !mayHaveCount(*copy(), next_))) continue;
    decide(packet, next_);
    const bool parity = findsParity(packet, next_);
    if (choices_ != 0 && tryChoices(next_)) {
      doubtful_ = copy() || undecided_ != 1 || distance_ != 2 || packet.count() == RadioPacket::NO_COUNT;
      makeBytes(packet, next_);
      hasParity_ = parity;
      return WHOLE;
    }
    if (parity) {
      isSaved_ = !copy();
      if (isSaved_) save(packet);
      beginParity(packet, next_);
      phase_ = Phase::CORRECTING;
      return PENDING;
    }
    next_++;
    return PENDING;
  }
  return lose(packet);
}

Mender::Progress Mender::lose(const RadioPacket &packet) {
  save(packet);
  return LOST;
}

// The nibbles whose symbols are nearest to one that came, and to the copy's. Their distance is the sum of both, or twice that
// of the one that is there.
uint16_t Mender::nearest(const RadioPacket &packet, uint8_t index, bool inTrailer, uint8_t &distance) const {
  const RadioPacket *const other = copy();
  const bool inOther = other && index < other->symbols;
  const uint8_t one = !inOther || index < packet.symbols ? packet.symbol(index) : other->symbol(index);
  const uint8_t two = inOther ? other->symbol(index) : one;
  return linecode::nearestTo(one, two, inTrailer, distance);
}

uint16_t Mender::nibblesAt(const RadioPacket &packet, uint8_t index, uint8_t count, uint8_t &distance) const {
  distance = 0;
  if (index < 2) return bitOf(index == 0 ? static_cast<uint8_t>(count >> 4) : static_cast<uint8_t>(count & 0x0F));
  return nearest(packet, index, false, distance);
}

void Mender::decide(const RadioPacket &packet, uint8_t count) {
  Crc16 crc;
  uint8_t byte = 0;
  choices_ = 1;
  undecided_ = 0;
  for (uint8_t i = 0; i < 2 * count; i++) {
    uint8_t distance;
    const uint16_t nibbles = nibblesAt(packet, i, count, distance);
    byte = static_cast<uint8_t>(byte | placed(firstOf(nibbles), i));
    if (!isOne(nibbles) && choices_ != 0) {
      const uint16_t choices = static_cast<uint16_t>(choices_ * linecode::onesOfWord(nibbles));
      choices_ = choices > MOST_CHOICES || undecided_ == MOST_UNDECIDED ? 0 : static_cast<uint8_t>(choices);
      distance_ = distance;
      if (choices_ != 0) {
        places_[undecided_] = i;
        nibbles_[undecided_++] = nibbles;
      }
    }
    if (i % 2 == 0) continue;
    crc.add(&byte, 1);
    byte = 0;
  }
  crc_ = crc.value();
}

#if JAVINO_MENDING

// Finds the one choice with which the CRC is right.
bool Mender::tryChoices(uint8_t count) {
  static const uint8_t MOST_NIBBLES = 20;  // of all undecided symbols together: 16 + 4, if their product is at most 64
  uint16_t changes[MOST_NIBBLES];          // of the CRC, for each nibble of each undecided symbol
  uint8_t ends[MOST_UNDECIDED];            // behind the last one of each symbol
  uint8_t at[MOST_UNDECIDED];              // the one that is tried
  uint8_t right[MOST_UNDECIDED];
  uint8_t used = 0;
  for (uint8_t k = 0; k < undecided_; k++) {
    at[k] = used;
    const uint8_t first = firstOf(nibbles_[k]);
    const uint8_t following = static_cast<uint8_t>(count - 1 - places_[k] / 2);
    for (uint8_t nibble = first; nibble < 16; nibble++) {
      if ((nibbles_[k] & bitOf(nibble)) == 0) continue;
      changes[used++] = Crc16::changeOf(placed(static_cast<uint8_t>(first ^ nibble), places_[k]), following);
    }
    ends[k] = used;
  }
  uint8_t found = 0;
  uint16_t crc = crc_;
  for (uint8_t left = choices_; left != 0; left--) {
    if (crc == RadioPacket::CRC_OF_INTACT) {
      found++;
      memcpy(right, at, sizeof right);
    }
    for (uint8_t k = 0; k < undecided_; k++) {  // the next choice
      crc ^= changes[at[k]];
      const bool wraps = ++at[k] == ends[k];
      if (wraps) at[k] = k == 0 ? 0 : ends[k - 1];
      crc ^= changes[at[k]];
      if (!wraps) break;
    }
  }
  if (found != 1) return false;
  for (uint8_t k = 0; k < undecided_; k++) {
    for (uint8_t skip = static_cast<uint8_t>(right[k] - (k == 0 ? 0 : ends[k - 1])); skip != 0; skip--)
      nibbles_[k] = static_cast<uint16_t>(nibbles_[k] & (nibbles_[k] - 1));
  }
  return true;
}

#else

// The same of one symbol, in a quarter of the flash.
bool Mender::tryChoices(uint8_t count) {
  if (undecided_ == 0) return crc_ == RadioPacket::CRC_OF_INTACT;
  const uint8_t first = firstOf(nibbles_[0]);
  uint16_t right = 0;
  for (uint8_t nibble = first; nibble < 16; nibble++) {
    if ((nibbles_[0] & bitOf(nibble)) == 0) continue;
    const uint16_t change = Crc16::changeOf(placed(static_cast<uint8_t>(first ^ nibble), places_[0]),
                                            static_cast<uint8_t>(count - 1 - places_[0] / 2));
    if ((crc_ ^ change) == RadioPacket::CRC_OF_INTACT) right |= bitOf(nibble);
  }
  nibbles_[0] = right;
  return right != 0 && isOne(right);
}

#endif

// Puts the bytes in the place of their symbols, as RadioPacket::makeBytes() does.
void Mender::makeBytes(RadioPacket &packet, uint8_t count) {
  uint8_t k = 0;
  uint8_t byte = 0;
  for (uint8_t i = 0; i < 2 * count; i++) {
    uint8_t distance;
    uint16_t nibbles = nibblesAt(packet, i, count, distance);
    if (k < undecided_ && places_[k] == i) nibbles = nibbles_[k++];
    byte = static_cast<uint8_t>(byte | placed(firstOf(nibbles), i));
    if (i % 2 == 0) continue;
    packet.room[i / 2] = byte;
    byte = 0;
  }
  packet.areBytes = true;
}

#if JAVINO_PARITY

bool Mender::findsParity(const RadioPacket &packet, uint8_t count) const {
  if (count < LEAST_KEPT) return false;
  const uint8_t end = static_cast<uint8_t>(2 * (count + 1 + linecode::parityLength(count)));
  const RadioPacket *from = packet.symbols >= end ? &packet : copy() && copy()->symbols >= end ? copy() : nullptr;
  if (!from) return false;
  const uint8_t at = static_cast<uint8_t>(2 * count);
  const uint8_t next = from->symbol(static_cast<uint8_t>(at + 1));
  return linecode::trailerOf(static_cast<uint16_t>(from->symbol(at) | next << linecode::BITS_PER_SYMBOL)) ==
         Trailer::PARITY;
}

// Takes the nearest bytes, and says which of them may be others. Parity that was not sent is such too.
void Mender::beginParity(RadioPacket &packet, uint8_t count) {
  const uint8_t end = static_cast<uint8_t>(count + reedsolomon::PARITY_LENGTH);
  const uint8_t sent = static_cast<uint8_t>(count + linecode::parityLength(count));
  parity_.begin(packet.room, end);
  uint8_t byte = 0;
  bool sure = true;
  for (uint8_t i = 0; i < 2 * end; i++) {
    uint8_t distance;
    uint16_t nibbles = 0xFFFF;
    if (i < 2 * count) {
      nibbles = nibblesAt(packet, i, count, distance);
    } else if (i < 2 * sent) {
      nibbles = nearest(packet, static_cast<uint8_t>(i + 2), true, distance);
    }
    sure = sure && isOne(nibbles);
    byte = static_cast<uint8_t>(byte | placed(firstOf(nibbles), i));
    if (i % 2 == 0) continue;
    if (!sure) parity_.erase(i / 2);
    packet.room[i / 2] = byte;
    byte = 0;
    sure = true;
  }
  packet.areBytes = true;
}

Mender::Progress Mender::correct(RadioPacket &packet) {
  const reedsolomon::Progress progress = parity_.step();
  if (progress == reedsolomon::Progress::PENDING) return PENDING;
  if (progress == reedsolomon::Progress::CORRECTED && packet.room[0] == next_ && packet.hasRightCrc()) {
    hasParity_ = true;
    return WHOLE;
  }
  if (!isSaved_ || !copy()) return LOST;
  // Its symbols are needed again: it may have another count.
  memcpy(packet.room, copy()->room, sizeof packet.room);
  packet.areBytes = false;
  next_++;
  phase_ = Phase::CHOOSING;
  return PENDING;
}

#else

bool Mender::findsParity(const RadioPacket &, uint8_t) const { return false; }
void Mender::beginParity(RadioPacket &, uint8_t) {}
Mender::Progress Mender::correct(RadioPacket &) { return LOST; }

#endif

#if JAVINO_DAMAGED_COPIES

void Mender::save(const RadioPacket &packet) {
  if (packet.symbols < 2 * LEAST_KEPT) return;
  if (like_ == NONE) {
    like_ = oldest_;
    oldest_ = static_cast<uint8_t>((oldest_ + 1) % config::DAMAGED_COPIES);
  }
  RadioPacket &place = copies_[like_];
  place.symbols = packet.symbols;
  place.areBytes = packet.areBytes;
  memcpy(place.room, packet.room, sizeof place.room);
}

// Only the bytes that are right.
void Mender::keep() {
  save(*packet_);
  if (like_ != NONE) copies_[like_].symbols = static_cast<uint8_t>(2 * packet_->room[0]);
}

#else

void Mender::save(const RadioPacket &) {}
void Mender::keep() {}

#endif

}  // namespace javino
