#include "RadioEncoder.h"

#include <string.h>

#if JAVINO_LARGE
#include "ReedSolomon.h"
#endif
#include "../support/Crc16.h"
#include "RadioPacket.h"

namespace javinolib {

bool RadioEncoder::start(const uint8_t *payload, uint8_t length, Trailer trailer, uint8_t *packet, uint8_t path) {
  if (length == 0 || length > MAX_RADIO_PAYLOAD) return false;
  const uint8_t count = static_cast<uint8_t>(length + linecode::PACKET_OVERHEAD);
  packet_ = packet;
  packet[0] = count;
  memcpy(packet + 1, payload, length);

  Crc16 crc;
  crc.add(packet, length + 1);
  const uint16_t sent = static_cast<uint16_t>(crc.value() ^ RadioPacket::crcOf(path));
  packet[length + 1] = static_cast<uint8_t>(sent);
  packet[length + 2] = static_cast<uint8_t>(sent >> 8);

  symbolCount_ = static_cast<uint8_t>(linecode::PREAMBLE_SYMBOLS + 2 * (count + addTrailer(trailer, packet, count)));
  symbolIndex_ = 0;
  symbol_ = symbolAt(0);
  bitsLeft_ = linecode::BITS_PER_SYMBOL;
  return true;
}

#if JAVINO_LARGE

uint8_t RadioEncoder::trailerLength(Trailer trailer, uint8_t length) {
  if (trailer == Trailer::PARITY) return static_cast<uint8_t>(1 + linecode::parityLength(length));
  return trailer == Trailer::MARK ? 1 : 0;
}

// Puts the trailer behind the packet. Returns its length.
uint8_t RadioEncoder::addTrailer(Trailer trailer, uint8_t *packet, uint8_t length) {
  if (trailer == Trailer::MARK) packet[length] = linecode::TRAILER_MARK;
  if (trailer == Trailer::PARITY) packet[length] = linecode::TRAILER_PARITY;
  if (trailer == Trailer::PARITY) reedsolomon::encode(packet, length, packet + length + 1);
  return trailerLength(trailer, length);
}

#else

uint8_t RadioEncoder::addTrailer(Trailer, uint8_t *, uint8_t) { return 0; }

#endif

bool RadioEncoder::next() {
  if (bitsLeft_ == 0) return false;
  const bool bit = symbol_ & 1;
  symbol_ >>= 1;
  bitsLeft_--;
  if (bitsLeft_ == 0 && ++symbolIndex_ < symbolCount_) {
    symbol_ = symbolAt(symbolIndex_);
    bitsLeft_ = linecode::BITS_PER_SYMBOL;
  }
  return bit;
}

uint8_t RadioEncoder::symbolAt(uint8_t index) const {
  if (index < linecode::PREAMBLE_SYMBOLS) return linecode::preambleSymbol(index);
  const uint8_t nibbleIndex = static_cast<uint8_t>(index - linecode::PREAMBLE_SYMBOLS);
  const uint8_t nibble = linecode::nibbleIn(packet_, nibbleIndex);
#if JAVINO_LARGE
  if (nibbleIndex >= 2 * packet_[0]) return linecode::trailerSymbolOf(nibble);
#endif
  return linecode::symbolOf(nibble);
}

}  // namespace javinolib
