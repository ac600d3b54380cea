#include "PacketDecoder.h"

#include "../support/Crc16.h"

namespace javinolib {

static const uint8_t FULL_BLOCK = 0xFF;  // the code of a block that no zero follows

PacketEvent PacketDecoder::add(uint8_t byte) {
  if (byte == 0) return finish();
  started_ = true;
  if (left_ == 0) {
    beginBlock(byte);
  } else {
    append(byte);
    left_--;
  }
  return PacketEvent::NONE;
}

uint16_t PacketDecoder::crc() const { return static_cast<uint16_t>(bytes_[length_ - 2] | bytes_[length_ - 1] << 8); }

void PacketDecoder::beginBlock(uint8_t code) {
  if (zeroOwed_) append(0);
  zeroOwed_ = code != FULL_BLOCK;
  left_ = static_cast<uint8_t>(code - 1);
}

void PacketDecoder::append(uint8_t byte) {
  if (next_ < end_) *next_ = byte;
  if (next_ <= end_) next_++;
}

PacketEvent PacketDecoder::finish() {
  if (!started_) return PacketEvent::NONE;
  const bool inBlock = left_ != 0;
  length_ = static_cast<Length>(next_ - bytes_);
  next_ = bytes_;
  left_ = 0;
  zeroOwed_ = false;
  started_ = false;
  return check(inBlock);
}

PacketEvent PacketDecoder::check(bool inBlock) const {
  if (inBlock) return PacketEvent::BAD_COBS;
  if (bytes_ + length_ > end_) return PacketEvent::TOO_LONG;
  if (length_ < MIN_PACKET_LENGTH) return PacketEvent::TOO_SHORT;
  Crc16 expected;
  expected.add(bytes_, static_cast<size_t>(length_ - 2));
  return expected.value() == crc() ? PacketEvent::PACKET : PacketEvent::BAD_CRC;
}

}  // namespace javinolib
