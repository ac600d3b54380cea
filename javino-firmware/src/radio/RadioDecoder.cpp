#include "RadioDecoder.h"

#include "../support/Counters.h"
#include "LineCode.h"

namespace javinolib {

namespace {

const uint8_t MOST_START_ERRORS = 3;

// Two of three symbols of noise are impossible, and the training and start behind it are six possible ones.
const int8_t NOISE = 8;
const int8_t NO_NOISE = -8;
const int8_t LEAST_NOISE = -16;

const uint8_t COUNT_SYMBOLS = 2;

// As many as the shortest acknowledgement has.
const uint8_t LEAST_UNCOUNTED = 42;

// Twelve bits and one behind them, without the first.
uint16_t shifted(uint16_t bits, bool next) { return static_cast<uint16_t>(bits >> 1 | (next ? linecode::TOP_BIT : 0)); }

}  // namespace

RadioDecoder::RadioDecoder(uint16_t bitTicks) : carrier_(bitTicks) {}

void RadioDecoder::add(bool bit) {
  oldTraining_ = shifted(oldTraining_, newTraining_ & 1);
  newTraining_ = shifted(newTraining_, bits_ & 1);
  bits_ = shifted(bits_, bit);
  const bool mayStart = phase_ < BODY || startErrors_ != 0 || noise_ > 0;  // else none would count
  if (mayStart && isStart()) return;
  if (phase_ == HUNTING || ++symbolBits_ < linecode::BITS_PER_SYMBOL) return;
  symbolBits_ = 0;
  addSymbol();
}

// Looks for a start in the last 36 bits. One that counts begins a packet.
bool RadioDecoder::isStart() {
  uint8_t wrong = linecode::onesOfWord(bits_ ^ linecode::START);
  if (wrong > MOST_START_ERRORS) return false;
  // The newest twelve bits of training are those that no receiver has missed.
  wrong = static_cast<uint8_t>(wrong + linecode::onesOfWord(newTraining_ ^ linecode::TRAINING));
  const bool isExact = wrong == 0;
  wrong = static_cast<uint8_t>(wrong + linecode::onesOfWord(oldTraining_ ^ linecode::TRAINING));
  if (isExact && wrong > MOST_START_ERRORS) wrong = MOST_START_ERRORS;
  if (wrong > MOST_START_ERRORS || !isBetterStart(wrong)) return false;
  begin(wrong);
  return true;
}

// Training with one wrong bit may look like a start, up to twelve bits before it. What follows a start differs from one in six
// bits or more, whatever the count.
bool RadioDecoder::isBetterStart(uint8_t wrong) const {
  if (phase_ <= COUNT) return true;
  if (startErrors_ == 0) return noise_ > 0;
  return noise_ > (wrong <= startErrors_ ? LEAST_NOISE : NO_NOISE);
}

void RadioDecoder::begin(uint8_t wrong) {
  if (phase_ == BODY) {
    giveUp();
  } else {
    close();
  }
  phase_ = COUNT;
  startErrors_ = wrong;
  noise_ = 0;
  symbolBits_ = 0;
  symbols_ = 0;
  end_ = COUNT_SYMBOLS;
}

void RadioDecoder::addSymbol() {
  const uint8_t symbol = static_cast<uint8_t>(bits_ >> linecode::BITS_PER_SYMBOL);
  if (linecode::onesOf(symbol) != linecode::BITS_PER_SYMBOL / 2) {
    if (++noise_ == NOISE) {
      refuse();
      return;
    }
  } else if (noise_ != LEAST_NOISE) {
    noise_--;
  }
  if (++symbols_ % 2 != 0) return;
  if (phase_ != COUNT) store();
  if (symbols_ < end_) return;
  switch (phase_) {
    case COUNT: startBody(); break;
    case BODY: endBody(); break;
    default: addToTrailer();
  }
}

// Puts the last two symbols to the packet: four lie in three bytes.
void RadioDecoder::store() {
  if (!packet_) return;
  if (symbols_ % 4 != 0) {
    next_[0] = static_cast<uint8_t>(bits_);
    next_[1] = static_cast<uint8_t>(bits_ >> 8);
    next_++;
  } else {
    next_[0] = static_cast<uint8_t>(next_[0] | bits_ << 4);
    next_[1] = static_cast<uint8_t>(bits_ >> 4);
    next_ += 2;
  }
}

// A count with a wrong symbol is known only by the most that it can be.
void RadioDecoder::startBody() {
  const uint8_t high = linecode::nibbleOf(static_cast<uint8_t>(bits_ & 0x3F));
  const uint8_t low = linecode::nibbleOf(static_cast<uint8_t>(bits_ >> linecode::BITS_PER_SYMBOL));
  counted_ = high != linecode::NO_NIBBLE && low != linecode::NO_NIBBLE;
  uint8_t most = linecode::MAX_COUNT;
  if (high != linecode::NO_NIBBLE) {
    const uint8_t count = static_cast<uint8_t>(high << 4 | (counted_ ? low : 0x0F));
    if (count < linecode::MIN_COUNT || (counted_ && count > most) || high > most >> 4) {
      refuse();
      return;
    }
    if (count < most) most = count;
  }
  end_ = static_cast<uint8_t>(2 * (counted_ ? most : most + linecode::TRAILER_LENGTH));
  phase_ = BODY;
  if (config::LARGE) trailer_ = Trailer::NONE;
  packet_ = queue_.claim();
  if (packet_) {
    packet_->areBytes = false;
    packet_->open = false;
    next_ = packet_->room;
  }
  store();
  carrier_.expect(static_cast<uint16_t>(linecode::BITS_PER_SYMBOL) * static_cast<uint8_t>(end_ - COUNT_SYMBOLS));
}

void RadioDecoder::endBody() {
  if (!packet_) {
    countUp(counters_.missed);
    hunt();
    return;
  }
  packet_->symbols = static_cast<uint8_t>(symbols_ & ~1);
  const bool mayGoOn = counted_ && linecode::TRAILER_LENGTH != 0;
  packet_->open = mayGoOn;
  queue_.commit();
  if (!mayGoOn) {
    hunt();
    return;
  }
  phase_ = TRAILER;
  end_ = static_cast<uint8_t>(end_ + 2);
  noise_ = LEAST_NOISE;
}

void RadioDecoder::addToTrailer() {
  if (!config::LARGE) return;
  if (phase_ == PARITY) {
    close();
    hunt();
    return;
  }
  trailer_ = linecode::trailerOf(bits_);
  if (trailer_ != Trailer::PARITY) {
    close();
    hunt();
    return;
  }
  const uint8_t symbols = static_cast<uint8_t>(2 * linecode::parityLength(static_cast<uint8_t>((symbols_ - 2) / 2)));
  end_ = static_cast<uint8_t>(end_ + symbols);
  phase_ = PARITY;
  noise_ = 0;
  carrier_.expect(static_cast<uint16_t>(linecode::BITS_PER_SYMBOL) * symbols);
}

// Nothing more comes for the packet that was queued.
void RadioDecoder::close() {
  if (!config::LARGE || (phase_ != TRAILER && phase_ != PARITY)) return;
  packet_->symbols = static_cast<uint8_t>(symbols_ & ~1);
  packet_->open = false;
}

void RadioDecoder::endOfSignal() {
  if (phase_ == BODY && !counted_) {
    endBody();
  } else if (phase_ == COUNT || phase_ == BODY) {
    refuse();
  }
  close();
  hunt();
}

void RadioDecoder::abandon() {
  if (phase_ == COUNT || phase_ == BODY) countUp(counters_.missed);
  close();
  bits_ = 0;
  newTraining_ = 0;
  oldTraining_ = 0;
  hunt();
}

void RadioDecoder::refuse() {
  if (phase_ >= BODY) carrier_.doubt();
  if (phase_ == BODY) {
    giveUp();
  } else if (phase_ == COUNT) {
    countUp(counters_.damaged);
  }
  close();
  hunt();
}

// Noise follows a packet at once where receivers give noise: one whose count is not known may have ended long ago.
void RadioDecoder::giveUp() {
  if (!counted_ && symbols_ >= LEAST_UNCOUNTED) {
    endBody();
  } else {
    countUp(counters_.damaged);
  }
}

}  // namespace javinolib
