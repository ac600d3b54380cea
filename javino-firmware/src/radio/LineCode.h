#pragma once

#include <stdint.h>

#include "../Config.h"
#include "Radio.h"

namespace javinolib {

/// The numbers of VirtualWire's line code (SPEC 6): each nibble travels as a symbol of six bits, three of them ones.
namespace linecode {

static const uint8_t BITS_PER_SYMBOL = 6;

/// The bits of the start symbols 0x38 and 0x2C as they lie in a 12-bit register that is filled from the top; and those of two
/// symbols of the training before them.
static const uint16_t START = 0xB38;
static const uint16_t TRAINING = 0xAAA;
static const uint16_t TOP_BIT = 0x800;

/// Symbols ahead of the first byte: six of training, then the two of the start symbol.
static const uint8_t PREAMBLE_SYMBOLS = 8;

/// Bytes of a packet that are not payload: one of count, two of CRC.
static const uint8_t PACKET_OVERHEAD = 3;

/// Bytes of the longest trailer (SPEC 6.1).
static const uint8_t TRAILER_LENGTH = JAVINO_LARGE ? 17 : 0;

/// Bytes of a packet without its trailer.
static const uint8_t MIN_COUNT = 1 + PACKET_OVERHEAD;
static const uint8_t MAX_COUNT = MAX_RADIO_PAYLOAD + PACKET_OVERHEAD;

/// The value that nibbleOf() gives for the 48 symbols that stand for none.
static const uint8_t NO_NIBBLE = 0xFF;

/// @param nibble 0…15
uint8_t symbolOf(uint8_t nibble);

/// @param symbol 0…63
/// @return 0…15, or NO_NIBBLE.
uint8_t nibbleOf(uint8_t symbol);

/// The first byte of a trailer (SPEC 6.1). On the air the two differ in each of their twelve bits, and in four or more from
/// silence, training and start.
static const uint8_t TRAILER_MARK = 0x78;    ///< nothing follows: the sender understands trailers
static const uint8_t TRAILER_PARITY = 0x87;  ///< the packet's parity follows

/// As symbolOf(), in the alphabet of trailers: no bits of these symbols, nor of others with these behind them, are the start.
uint8_t trailerSymbolOf(uint8_t nibble);

/// As nibbleOf(), in the alphabet of trailers.
uint8_t trailerNibbleOf(uint8_t symbol);

/// @return how many bits of a byte are ones.
uint8_t onesOf(uint8_t byte);

/// @return how many of 16 bits are ones.
inline uint8_t onesOfWord(uint16_t word) {
  return static_cast<uint8_t>(onesOf(static_cast<uint8_t>(word)) + onesOf(static_cast<uint8_t>(word >> 8)));
}

/// A nibble of some bytes, high nibbles first, as they travel.
inline uint8_t nibbleIn(const uint8_t *bytes, uint8_t index) {
  const uint8_t byte = bytes[index / 2];
  return index % 2 == 0 ? static_cast<uint8_t>(byte >> 4) : static_cast<uint8_t>(byte & 0x0F);
}

/// The nibbles whose symbols differ in the fewest bits from two that came in their place, both together.
/// @param inTrailer whether they are of the trailers' alphabet
/// @param distance set to the number of these bits, 0…6
/// @return bit k for nibble k
uint16_t nearestTo(uint8_t one, uint8_t two, bool inTrailer, uint8_t &distance);

/// Reads the word behind a packet. Of PARITY two bits may be wrong; of MARK one, as noise behind a packet may look like it.
/// @param bits twelve, the first one lowest
Trailer trailerOf(uint16_t bits);

/// How many bytes of parity are sent: 12 for a packet that is that short, 16 for others.
/// @param count 4…80
uint8_t parityLength(uint8_t count);

/// @param index 0…7
/// @return that symbol of the training and the start.
uint8_t preambleSymbol(uint8_t index);

}  // namespace linecode
}  // namespace javinolib
