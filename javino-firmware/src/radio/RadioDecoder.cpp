#include "RadioDecoder.h"

#include "Counting.h"
#include "LineCode.h"

namespace javino {

namespace {

const uint8_t MIN_COUNT = 1 + linecode::PACKET_OVERHEAD;
const uint8_t MAX_COUNT = MAX_RADIO_PAYLOAD + linecode::PACKET_OVERHEAD;

// The CRC of anything with its own CRC behind it, low byte first (the complement of X-25's residue 0xF0B8).
const uint16_t CRC_OF_INTACT_PACKET = 0x0F47;

}  // namespace

RadioDecoder::RadioDecoder(RadioQueue &queue, RadioCounters &counters)
    : queue_(queue), counters_(counters), bits_(0), highNibble_(0), payload_(nullptr) {
  hunt();
}

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

void RadioDecoder::abandon() {
  if (!hunting_) countUp(counters_.missed);
  bits_ = 0;
  hunt();
}

void RadioDecoder::addSymbol(uint8_t symbol) {
  const uint8_t nibble = linecode::nibbleOf(symbol);
  if (nibble == linecode::NO_NIBBLE) {
    refuse();
    return;
  }
  lowNibble_ = !lowNibble_;
  if (lowNibble_) {
    highNibble_ = nibble;
  } else {
    addByte(static_cast<uint8_t>(highNibble_ << 4 | nibble));
  }
}

void RadioDecoder::addByte(uint8_t byte) {
  if (count_ == 0) {
    startPacket(byte);
    return;
  }
  crc_.add(byte);
  const bool isPayload = received_ < count_ - 2;
  if (isPayload && payload_) payload_[received_ - 1] = byte;
  if (++received_ == count_) endPacket();
}

void RadioDecoder::startPacket(uint8_t count) {
  if (count < MIN_COUNT || count > MAX_COUNT) {
    refuse();
    return;
  }
  count_ = count;
  received_ = 1;
  crc_ = Crc16();
  crc_.add(count);
  payload_ = queue_.claim();
}

void RadioDecoder::endPacket() {
  if (crc_.value() != CRC_OF_INTACT_PACKET) {
    refuse();
    return;
  }
  if (payload_) {
    queue_.commit(static_cast<uint8_t>(count_ - linecode::PACKET_OVERHEAD));
    countUp(counters_.received);
  } else {
    countUp(counters_.missed);
  }
  hunt();
}

void RadioDecoder::refuse() {
  countUp(counters_.damaged);
  hunt();
}

void RadioDecoder::hunt() {
  hunting_ = true;
  symbolBits_ = 0;
  lowNibble_ = false;
  count_ = 0;
  received_ = 0;
}

}  // namespace javino
