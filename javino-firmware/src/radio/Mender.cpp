#include "Mender.h"

#include <string.h>

namespace javinolib {

namespace {

// A nibble where it lies in a byte.
uint8_t placed(uint8_t nibble, uint8_t index) { return index % 2 == 0 ? static_cast<uint8_t>(nibble << 4) : nibble; }

}  // namespace

Mender::Progress Mender::step(RadioPacket &packet) {
  packet_ = &packet;
  if (progress_ == PENDING) progress_ = work(packet);
  return progress_;
}

// Whether a CRC is right.
inline bool Mender::note(uint16_t path) {
  if (path >= RadioPacket::NO_PATH) return false;
  path_ = static_cast<uint8_t>(path);
  return true;
}

#if JAVINO_LARGE

const uint8_t Mender::MOST_UNDECIDED;

namespace {

// Two copies differ in 6 % of their bits where 3 % of all bits are wrong; two packets of one sender, in half of those that
// nonce, content and tag take, which is a sixth of the shortest.
const uint8_t LIKE_PART = 8;

// The most wrong bits, of 24, of a CRC. Two copies differ in one or two.
const uint8_t MOST_OF_CRC = 5;
const uint8_t CRC_SYMBOLS = 4;

// A fragment that asks for an answer, and the same one that does not, differ in a digit and in the CRC; the others of their bits
// tell of each other. As the CRC does not tell then whether they are the same, fewer may differ.
const uint8_t LIKE_BUT_FOR_CRC_PART = 12;
const uint8_t DIGIT_SYMBOL = 8;

// Symbols that one step decides on, or writes: an even number. One takes 1600 cycles at most.
const uint8_t STEP_SYMBOLS = 16;

// Most shorter ones are acknowledgements, which their sender knows beforehand; and there is little in them that could tell a
// wrong guess from a right one.
const uint8_t LEAST_KEPT = 24;

JAVINO_NOINLINE uint16_t bitOf(uint8_t nibble) { return static_cast<uint16_t>(1 << nibble); }

JAVINO_NOINLINE uint8_t firstOf(uint16_t nibbles) {
  uint8_t half = static_cast<uint8_t>(nibbles);
  uint8_t nibble = 0;
  if (half == 0) {
    half = static_cast<uint8_t>(nibbles >> 8);
    nibble = 8;
  }
  for (; (half & 1) == 0; half >>= 1) nibble++;
  return nibble;
}

bool isOne(uint16_t nibbles) { return (nibbles & (nibbles - 1)) == 0; }

// By what the CRC changes where these bits of a nibble do, as one step of it tells for each bit from that for the next higher.
uint16_t changeOf(uint8_t bits, uint16_t ofHighest) {
  uint16_t change = 0;
  for (uint8_t bit = 8; bit != 0; bit >>= 1) {
    if ((bits & bit) != 0) change ^= ofHighest;
    ofHighest = static_cast<uint16_t>(ofHighest >> 1 ^ ((ofHighest & 1) != 0 ? 0x8408 : 0));
  }
  return change;
}

}  // namespace

Mender::Progress Mender::work(RadioPacket &packet) {
  switch (phase_) {
    case Phase::LOOKING: return look(packet);
    case Phase::COMPARING: return compare(packet);
    case Phase::CHOOSING: return choose(packet);
    case Phase::WRITING: return write(packet);
    case Phase::CORRECTING: return correct(packet);
  }
  return LOST;
}

// The end of a good packet is not waited for.
Mender::Progress Mender::look(RadioPacket &packet) {
  like_ = nullptr;
  isOther_ = false;
  mended_ = false;
  doubtful_ = false;
  if (note(packet.path())) {
    packet.makeBytes(packet.count());
    return WHOLE;
  }
  if (config::LARGE && packet.open) return PENDING;
  mended_ = true;
  doubtful_ = true;
  next_ = 0;
  phase_ = Phase::COMPARING;
  return PENDING;
}

#if JAVINO_LARGE

// Looks at one copy at a time.
Mender::Progress Mender::compare(RadioPacket &packet) {
  RadioPacket &copy = copies_[next_];
  if (isLike(packet, copy)) {
    like_ = &copy;
  } else if (++next_ < config::DAMAGED_COPIES) {
    return PENDING;
  }
  if (like_ && copy.areBytes && !isOther_) {
    trailer_ = trailerOf(packet, copy.room[0]);
    memcpy(packet.room, copy.room, sizeof packet.room);
    packet.areBytes = true;
    note(packet.pathOfBytes());
    return WHOLE;
  }
  return choose(linecode::MIN_COUNT);
}

bool Mender::isLike(const RadioPacket &packet, const RadioPacket &copy) {
  isOther_ = false;
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
  const uint8_t end = static_cast<uint8_t>(known != RadioPacket::NO_COUNT ? symbols - CRC_SYMBOLS : symbols);
  uint8_t differ = 0;
  uint8_t ofCrc = 0;
  const uint8_t most = static_cast<uint8_t>(symbols * (linecode::BITS_PER_SYMBOL / 2) / (LIKE_PART / 2));
  for (uint8_t i = 0; i < symbols; i++) {
    const uint8_t bits = linecode::onesOf(packet.symbol(i) ^ copy.symbol(i));
    if (i >= end) {
      ofCrc = static_cast<uint8_t>(ofCrc + bits);
      continue;
    }
    differ = static_cast<uint8_t>(differ + bits);
    if (differ > most) return false;
  }
  isOther_ = ofCrc > MOST_OF_CRC;
  return !isOther_ || differ <= symbols / (LIKE_BUT_FOR_CRC_PART / linecode::BITS_PER_SYMBOL);
}

#else

Mender::Progress Mender::compare(RadioPacket &) { return choose(linecode::MIN_COUNT); }

#endif

// Whether this is the packet's count; where that came with a wrong bit, whether it may be.
bool Mender::mayHaveCount(const RadioPacket &packet, uint8_t count) const {
  const uint8_t known = packet.count();
  if (known != RadioPacket::NO_COUNT) return count == known;
  return linecode::onesOf(packet.symbol(0) ^ linecode::symbolOf(static_cast<uint8_t>(count >> 4))) <= 1 &&
         linecode::onesOf(packet.symbol(1) ^ linecode::symbolOf(count)) <= 1;
}

// Goes on with the first possible count from this one on.
Mender::Progress Mender::choose(uint8_t count) {
  next_ = count;
  at_ = 0;
  crc_ = Crc16();
  choices_ = 1;
  undecided_ = 0;
  phase_ = Phase::CHOOSING;
  return PENDING;
}

Mender::Progress Mender::choose(RadioPacket &packet) {
  for (;; next_++) {
    if (next_ > linecode::MAX_COUNT || 2 * next_ > packet.symbols) return lose(packet);
    if (mayHaveCount(packet, next_) && (!copy() || mayHaveCount(*copy(), next_))) break;
  }
  if (at_ < 2 * next_) {
    decide(packet);
    return PENDING;
  }
  const bool hasParity = findsParity(packet);
  if (choices_ != 0 && tryChoices()) {
    doubtful_ = copy() || undecided_ != 1 || distance_ != 2 || packet.count() == RadioPacket::NO_COUNT;
  } else if (hasParity) {
    isSaved_ = !copy();
    if (isSaved_) save(packet);
    beginParity(packet);
  } else {
    return choose(static_cast<uint8_t>(next_ + 1));
  }
  at_ = 0;
  phase_ = Phase::WRITING;
  return PENDING;
}

Mender::Progress Mender::lose(const RadioPacket &packet) {
  save(packet);
  return LOST;
}

// The nibbles whose symbols are nearest to one that came, and to the copy's. Their distance is the sum of both, or twice that
// of the one that is there.
uint16_t Mender::nearest(const RadioPacket &packet, uint8_t index, bool inTrailer, uint8_t &distance) const {
  const RadioPacket *const other = copy();
  const bool differs = isOther_ && (inTrailer || index + CRC_SYMBOLS >= 2 * next_ || index / 2 == DIGIT_SYMBOL / 2);
  const bool inOther = other && !differs && index < other->symbols;
  const uint8_t one = !inOther || index < packet.symbols ? packet.symbol(index) : other->symbol(index);
  const uint8_t two = inOther ? other->symbol(index) : one;
  return linecode::nearestTo(one, two, inTrailer, distance);
}

// Parity that was not sent may be any.
uint16_t Mender::nibblesAt(const RadioPacket &packet, uint8_t index, uint8_t &distance) const {
  distance = 0;
  if (index < 2) return bitOf(index == 0 ? static_cast<uint8_t>(next_ >> 4) : static_cast<uint8_t>(next_ & 0x0F));
  if (!config::LARGE || index < 2 * next_) return nearest(packet, index, false, distance);
  if (index >= 2 * (next_ + linecode::parityLength(next_))) return ANY;
  return nearest(packet, static_cast<uint8_t>(index + 2), true, distance);
}

uint8_t Mender::endOfStep() const {
  return static_cast<uint8_t>(end_ - at_ < STEP_SYMBOLS ? end_ : at_ + STEP_SYMBOLS);
}

void Mender::decide(const RadioPacket &packet) {
  uint8_t byte = 0;
  end_ = static_cast<uint8_t>(2 * next_);
  for (const uint8_t end = endOfStep(); at_ < end; at_++) {
    uint8_t distance;
    const uint16_t nibbles = nibblesAt(packet, at_, distance);
    byte = static_cast<uint8_t>(byte | placed(firstOf(nibbles), at_));
    if (!isOne(nibbles) && choices_ != 0) {
      const uint16_t choices = static_cast<uint16_t>(choices_ * linecode::onesOfWord(nibbles));
      choices_ = choices > MOST_CHOICES || undecided_ == MOST_UNDECIDED ? 0 : static_cast<uint8_t>(choices);
      distance_ = distance;
      if (choices_ != 0) {
        places_[undecided_] = at_;
        nibbles_[undecided_++] = nibbles;
      }
    }
    if (at_ % 2 == 0) continue;
    crc_.add(&byte, 1);
    byte = 0;
  }
}

// Finds the one choice with which the CRC is right.
bool Mender::tryChoices() {
  uint16_t changes[MOST_UNDECIDED];  // of the CRC, where the highest bit of a symbol's nibble changes
  uint8_t tried[MOST_UNDECIDED];
  uint8_t right[MOST_UNDECIDED];
  for (uint8_t k = 0; k < undecided_; k++) {
    changes[k] = Crc16::changeOf(placed(8, places_[k]), static_cast<uint8_t>(next_ - 1 - places_[k] / 2));
    tried[k] = firstOf(nibbles_[k]);
  }
  uint8_t found = 0;
  uint16_t crc = crc_.value();
  for (uint8_t left = choices_; left != 0; left--) {
    if (note(RadioPacket::pathOf(crc))) {
      found++;
      memcpy(right, tried, sizeof right);
    }
    for (uint8_t k = 0; k < undecided_; k++) {  // the next choice
      uint8_t nibble = tried[k];
      do {
        nibble = (nibble + 1) & 0x0F;
      } while ((nibbles_[k] & bitOf(nibble)) == 0);
      crc ^= changeOf(tried[k] ^ nibble, changes[k]);
      const bool wraps = nibble <= tried[k];
      tried[k] = nibble;
      if (!wraps) break;
    }
  }
  if (found != 1) return false;
  for (uint8_t k = 0; k < undecided_; k++) nibbles_[k] = bitOf(right[k]);
  return true;
}

// Puts the bytes in the place of their symbols, as RadioPacket::makeBytes() does. Where parity is to tell, it says which of them
// may be others.
Mender::Progress Mender::write(RadioPacket &packet) {
  const bool corrects = end_ != 2 * next_;
  uint8_t byte = 0;
  bool sure = true;
  for (const uint8_t end = endOfStep(); at_ < end; at_++) {
    uint8_t distance;
    uint16_t nibbles = nibblesAt(packet, at_, distance);
    for (uint8_t k = 0; !corrects && k < undecided_; k++) {
      if (places_[k] == at_) nibbles = nibbles_[k];
    }
    sure = sure && isOne(nibbles);
    byte = static_cast<uint8_t>(byte | placed(firstOf(nibbles), at_));
    if (at_ % 2 == 0) continue;
    if (!sure) erase(static_cast<uint8_t>(at_ / 2));
    packet.room[at_ / 2] = byte;
    byte = 0;
    sure = true;
  }
  if (at_ < end_) return PENDING;
  packet.areBytes = true;
  if (!corrects) return WHOLE;
  phase_ = Phase::CORRECTING;
  return PENDING;
}

#if JAVINO_LARGE

Trailer Mender::trailerOf(const RadioPacket &packet, uint8_t count) {
  const uint8_t at = static_cast<uint8_t>(2 * count);
  if (packet.symbols < at + 2) return Trailer::NONE;
  const uint16_t second = packet.symbol(static_cast<uint8_t>(at + 1));
  return linecode::trailerOf(static_cast<uint16_t>(packet.symbol(at) | second << linecode::BITS_PER_SYMBOL));
}

// Behind the packet, or behind its copy, whose parity is the same.
bool Mender::findsParity(const RadioPacket &packet) {
  trailer_ = trailerOf(packet, next_);
  if (next_ < LEAST_KEPT) return false;
  const uint8_t end = static_cast<uint8_t>(2 * (next_ + 1 + linecode::parityLength(next_)));
  if (packet.symbols >= end) return trailer_ == Trailer::PARITY;
  return copy() && !isOther_ && copy()->symbols >= end && trailerOf(*copy(), next_) == Trailer::PARITY;
}

void Mender::beginParity(RadioPacket &packet) {
  const uint8_t bytes = static_cast<uint8_t>(next_ + reedsolomon::PARITY_LENGTH);
  end_ = static_cast<uint8_t>(2 * bytes);
  parity_.begin(packet.room, bytes);
}

void Mender::erase(uint8_t byte) { parity_.erase(byte); }

Mender::Progress Mender::correct(RadioPacket &packet) {
  const reedsolomon::Progress progress = parity_.step();
  if (progress == reedsolomon::Progress::PENDING) return PENDING;
  if (progress == reedsolomon::Progress::CORRECTED && packet.room[0] == next_ && note(packet.pathOfBytes())) {
    return WHOLE;
  }
  if (!isSaved_ || !copy()) return LOST;
  // Its symbols are needed again: it may have another count.
  memcpy(packet.room, copy()->room, sizeof packet.room);
  packet.areBytes = false;
  return choose(static_cast<uint8_t>(next_ + 1));
}

#else

Trailer Mender::trailerOf(const RadioPacket &, uint8_t) { return Trailer::NONE; }
bool Mender::findsParity(const RadioPacket &) { return false; }
void Mender::beginParity(RadioPacket &) {}
void Mender::erase(uint8_t) {}
Mender::Progress Mender::correct(RadioPacket &) { return LOST; }

#endif

#if JAVINO_LARGE

void Mender::save(const RadioPacket &packet) {
  if (packet.symbols < 2 * LEAST_KEPT) return;
  if (!like_) {
    like_ = copies_ + oldest_;
    oldest_ = static_cast<uint8_t>((oldest_ + 1) % config::DAMAGED_COPIES);
  }
  RadioPacket &place = *like_;
  place.symbols = packet.symbols;
  place.areBytes = packet.areBytes;
  memcpy(place.room, packet.room, sizeof place.room);
}

// Only the bytes that are right.
void Mender::keep() {
  save(*packet_);
  if (like_) like_->symbols = static_cast<uint8_t>(2 * packet_->room[0]);
}

void Mender::forget() {
  if (like_) like_->symbols = 0;
}

#else

void Mender::save(const RadioPacket &) {}
void Mender::keep() {}
void Mender::forget() {}

#endif

#else

// Mends one symbol, where only one nibble is a bit away from it and makes the CRC right: with nothing kept, and so in one step.
Mender::Progress Mender::work(RadioPacket &packet) {
  const uint8_t count = packet.count();
  mended_ = false;
  if (count == RadioPacket::NO_COUNT || 2 * count > packet.symbols) return LOST;
  uint8_t place = 0;
  uint8_t wrong = 0;
  for (uint8_t i = 2; i < 2 * count; i++) {
    const uint8_t symbol = packet.symbol(i);
    if (linecode::nibbleOf(symbol) != linecode::NO_NIBBLE) continue;
    if (place != 0) return LOST;
    place = i;
    wrong = symbol;
  }
  packet.makeBytes(count);
  const uint16_t path = packet.pathOfBytes();
  if (place == 0) return note(path) ? WHOLE : LOST;
  uint8_t *const byte = packet.room + place / 2;
  for (uint8_t nibble = 0; nibble < 16; nibble++) {
    if (linecode::onesOf(linecode::symbolOf(nibble) ^ wrong) != 1) continue;
    const uint8_t change = placed(static_cast<uint8_t>(nibble ^ 0x0F), place);
    if (!note(path ^ Crc16::changeOf(change, static_cast<uint8_t>(count - 1 - place / 2)))) continue;
    if (mended_) return LOST;
    mended_ = true;
    *byte ^= change;
  }
  return mended_ ? WHOLE : LOST;
}

#endif

}  // namespace javinolib
