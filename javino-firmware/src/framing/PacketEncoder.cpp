#include "PacketEncoder.h"

namespace javinolib {

static const uint8_t MAX_RUN = 254;

void PacketEncoder::start(uint8_t *bytes, Length length) {
  next_ = bytes;
  end_ = bytes + length;
  crc_ = Crc16();
  closed_ = false;
  state_ = BLOCK;
}

uint8_t PacketEncoder::next() {
  switch (state_) {
    case BLOCK: return beginBlock();
    case DATA: {
      const uint8_t byte = *next_++;
      if (--left_ == 0) endBlock();
      return byte;
    }
    default: state_ = DONE; return 0;
  }
}

// Looks at each byte once, up to the zero behind the block: so this is where the CRC is computed.
uint8_t PacketEncoder::beginBlock() {
  const uint8_t *at = next_;
  uint8_t left = 0;
  for (; left != MAX_RUN; left++, at++) {
    if (at == end_) {
      if (closed_) break;
      addCrc();
    }
    if (!closed_) crc_.add(at, 1);
    if (*at == 0) break;
  }
  left_ = left;
  full_ = left == MAX_RUN;
  if (left == 0) {
    endBlock();
  } else {
    state_ = DATA;
  }
  return static_cast<uint8_t>(left + 1);
}

// A zero that ends a block is not sent, and is always followed by a block, be it an empty one.
void PacketEncoder::endBlock() {
  state_ = next_ == end_ && closed_ ? CLOSE : BLOCK;
  if (!full_ && state_ == BLOCK) next_++;
}

void PacketEncoder::addCrc() {
  end_[0] = static_cast<uint8_t>(crc_.value());
  end_[1] = static_cast<uint8_t>(crc_.value() >> 8);
  end_ += 2;
  closed_ = true;
}

}  // namespace javinolib
