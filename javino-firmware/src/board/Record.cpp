#include "Record.h"

namespace javino {

const uint8_t Record::HEAD_LENGTH;

Record::Record(Reply &reply, char type) : reply_(reply), start_(reply.mark()) {
  const uint8_t head[HEAD_LENGTH] = {static_cast<uint8_t>(type), 0, 0};
  fits_ = reply_.add(head, HEAD_LENGTH);
}

void Record::add(uint8_t byte) { add(&byte, 1); }

void Record::add(const uint8_t *bytes, uint16_t length) { fits_ = fits_ && reply_.add(bytes, length); }

bool Record::close() {
  if (!fits_) {
    reply_.truncate(start_);
    return false;
  }
  const uint16_t length = static_cast<uint16_t>(reply_.mark() - start_ - HEAD_LENGTH);
  reply_.replace(static_cast<uint16_t>(start_ + 1), static_cast<uint8_t>(length >> 8));
  reply_.replace(static_cast<uint16_t>(start_ + 2), static_cast<uint8_t>(length));
  return true;
}

}  // namespace javino
