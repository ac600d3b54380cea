#include "CobsEncoder.h"

namespace javino {

static const uint8_t MAX_RUN = 254;

void CobsEncoder::start(const uint8_t *bytes, uint16_t length) {
  next_ = bytes;
  end_ = bytes + length;
  state_ = BLOCK;
}

uint8_t CobsEncoder::next() {
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

uint8_t CobsEncoder::beginBlock() {
  left_ = 0;
  while (left_ < MAX_RUN && next_ + left_ != end_ && next_[left_] != 0) left_++;
  full_ = left_ == MAX_RUN;
  const uint8_t code = static_cast<uint8_t>(left_ + 1);
  if (left_ == 0) {
    endBlock();
  } else {
    state_ = DATA;
  }
  return code;
}

// A zero that ends a block is not sent, and is always followed by a block, be it an empty one.
void CobsEncoder::endBlock() {
  state_ = next_ == end_ ? CLOSE : BLOCK;
  if (!full_ && next_ != end_) next_++;
}

}  // namespace javino
