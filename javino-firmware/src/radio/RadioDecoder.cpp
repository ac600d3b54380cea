#include "RadioDecoder.h"

#include "../support/Counters.h"
#include "LineCode.h"

namespace javino {

namespace {

const uint8_t MIN_COUNT = 1 + linecode::PACKET_OVERHEAD;
const uint8_t MAX_COUNT = MAX_RADIO_PAYLOAD + linecode::PACKET_OVERHEAD;

}  // namespace

RadioDecoder::RadioDecoder(uint16_t bitTicks)
    : hunting_(true), wrongNibble_(RadioPacket::NO_NIBBLE), carrier_(bitTicks) {}

void RadioDecoder::add(bool bit) {
  bits_ >>= 1;
  if (bit) bits_ |= linecode::START_TOP_BIT;
  if (hunting_) {
    hunting_ = bits_ != linecode::START;
    return;
  }
  if (++symbolBits_ < linecode::BITS_PER_SYMBOL) return;
  symbolBits_ = 0;
  addSymbol(static_cast<uint8_t>(bits_ >> linecode::BITS_PER_SYMBOL));
}

void RadioDecoder::endOfSignal() {
  if (!hunting_) refuse();
}

void RadioDecoder::abandon() {
  if (!hunting_) countUp(counters_.missed);
  bits_ = 0;
  hunt();
}

void RadioDecoder::addSymbol(uint8_t symbol) {
  uint8_t nibble = linecode::nibbleOf(symbol);
  if (nibble == linecode::NO_NIBBLE) {
    if (!mayBeMended(symbol)) {
      refuse();
      return;
    }
    wrongNibble_ = static_cast<uint8_t>(2 * received_ + lowNibble_);
    wrongSymbol_ = symbol;
    nibble = 0;
  }
  lowNibble_ = !lowNibble_;
  if (lowNibble_) {
    highNibble_ = nibble;
  } else {
    addByte(static_cast<uint8_t>(highNibble_ << 4 | nibble));
  }
}

bool RadioDecoder::mayBeMended(uint8_t symbol) const {
  return count_ != 0 && wrongNibble_ == RadioPacket::NO_NIBBLE && linecode::isOneBitOff(symbol);
}

void RadioDecoder::addByte(uint8_t byte) {
  if (count_ == 0) {
    startPacket(byte);
    return;
  }
  if (packet_) packet_->bytes[received_] = byte;
  if (++received_ == count_) endPacket();
}

void RadioDecoder::startPacket(uint8_t count) {
  if (count < MIN_COUNT || count > MAX_COUNT) {
    refuse();
    return;
  }
  count_ = count;
  received_ = 1;
  packet_ = queue_.claim();
  carrier_.expect(static_cast<uint16_t>(2 * linecode::BITS_PER_SYMBOL) * static_cast<uint8_t>(count - 1));
}

void RadioDecoder::endPacket() {
  if (packet_) {
    packet_->bytes[0] = count_;
    packet_->wrongNibble = wrongNibble_;
    packet_->wrongSymbol = wrongSymbol_;
    queue_.commit();
  } else {
    countUp(counters_.missed);
  }
  hunt();
}

void RadioDecoder::refuse() {
  if (count_ != 0) carrier_.doubt();
  countUp(counters_.damaged);
  hunt();
}

void RadioDecoder::hunt() {
  hunting_ = true;
  symbolBits_ = 0;
  lowNibble_ = false;
  count_ = 0;
  received_ = 0;
  wrongNibble_ = RadioPacket::NO_NIBBLE;
}

}  // namespace javino
