#include "RadioEncoder.h"

#include <string.h>

#include "../support/Crc16.h"

namespace javino {

bool RadioEncoder::start(const uint8_t *payload, uint8_t length, uint8_t *packet) {
  if (length == 0 || length > MAX_RADIO_PAYLOAD) return false;
  packetLength_ = static_cast<uint8_t>(length + linecode::PACKET_OVERHEAD);
  packet_ = packet;
  packet[0] = packetLength_;
  memcpy(packet + 1, payload, length);

  Crc16 crc;
  crc.add(packet, length + 1);
  packet[length + 1] = static_cast<uint8_t>(crc.value());
  packet[length + 2] = static_cast<uint8_t>(crc.value() >> 8);

  symbolIndex_ = 0;
  symbol_ = symbolAt(0);
  bitsLeft_ = linecode::BITS_PER_SYMBOL;
  return true;
}

bool RadioEncoder::next() {
  if (bitsLeft_ == 0) return false;
  const bool bit = symbol_ & 1;
  symbol_ >>= 1;
  bitsLeft_--;
  if (bitsLeft_ == 0 && ++symbolIndex_ < symbolCount()) {
    symbol_ = symbolAt(symbolIndex_);
    bitsLeft_ = linecode::BITS_PER_SYMBOL;
  }
  return bit;
}

uint8_t RadioEncoder::symbolAt(uint8_t index) const {
  if (index < linecode::PREAMBLE_SYMBOLS) return linecode::preambleSymbol(index);
  const uint8_t nibbleIndex = static_cast<uint8_t>(index - linecode::PREAMBLE_SYMBOLS);
  const uint8_t byte = packet_[nibbleIndex / 2];
  const bool highNibble = nibbleIndex % 2 == 0;
  return linecode::symbolOf(highNibble ? static_cast<uint8_t>(byte >> 4) : byte);
}

}  // namespace javino
