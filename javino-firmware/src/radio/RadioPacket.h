#pragma once

#include <stdint.h>

#include "../Config.h"
#include "LineCode.h"
#include "Radio.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// A packet as it came from the air (SPEC 6), or one that is being sent.
///
/// Its symbols are kept as they came, right or wrong: a wrong one still tells most of its bits, and with another copy of the
/// packet, or with parity, they all come right (Mender.h). Bytes are made of them outside of interrupts.
struct RadioPacket {
  /// The symbols of count, payload, CRC and trailer.
  static const uint8_t MAX_BYTES = MAX_RADIO_PAYLOAD + linecode::PACKET_OVERHEAD + linecode::TRAILER_LENGTH;
  static const uint8_t MAX_SYMBOLS = 2 * MAX_BYTES;
  static const uint8_t NO_COUNT = 0;

  /// The CRC of anything with its own CRC behind it, low byte first (the complement of X-25's residue 0xF0B8).
  static const uint16_t CRC_OF_INTACT = 0x0F47;

  static const uint8_t NO_PATH = PATHS;

  /// The value with which the CRC in a packet of this path is XORed: the CRC of the whole packet then differs by the path from
  /// that above.
  static uint16_t crcOf(uint8_t path) { return static_cast<uint16_t>(path ^ path << 4 ^ path << 11); }

  /// The path of a packet where this is the CRC of all its bytes; NO_PATH or more where that is wrong.
  static uint16_t pathOf(uint16_t crc) { return crc ^ CRC_OF_INTACT; }

  uint8_t symbols JAVINO_ZEROED;     ///< that have come, 0…MAX_SYMBOLS; of bytes that are known, two each
  bool areBytes JAVINO_ZEROED;       ///< room has the bytes; else six bits of each symbol, the first one lowest
  volatile bool open JAVINO_ZEROED;  ///< more may still come: only the interrupt has this, and no one else writes it
  uint8_t room[(MAX_BYTES * linecode::BITS_PER_SYMBOL * 2 + 7) / 8];

  /// @param index less than `symbols`
  uint8_t symbol(uint8_t index) const;

  /// The count, 4…80, if both of its symbols are in the table; NO_COUNT else. At least two symbols have come.
  uint8_t count() const;

  /// The path of the packet; NO_PATH or more where a symbol is not in the table or the CRC is wrong.
  uint16_t path() const;

  /// Bytes, once they are known: of so many as the count says, and perhaps of more.
  uint8_t *bytes() { return room; }
  const uint8_t *bytes() const { return room; }
  uint8_t *payload() { return room + 1; }
  const uint8_t *payload() const { return room + 1; }

  /// @return 1…77.
  uint8_t payloadLength() const { return static_cast<uint8_t>(room[0] - linecode::PACKET_OVERHEAD); }

  /// The byte that two symbols stand for; 15 is the nibble of one that is not in the table.
  /// @param index of a byte both of whose symbols have come
  uint8_t readByte(uint8_t index) const { return static_cast<uint8_t>(byte(index)); }

  /// Puts so many bytes, as readByte() tells them, in the place of their symbols.
  void makeBytes(uint8_t length);

  /// As path(), where room has the bytes.
  uint16_t pathOfBytes() const;

  /// By how many bits the symbols from `first` on differ from those of these bytes.
  /// @return 65535 where fewer have come
  uint16_t wrongBits(uint8_t first, const uint8_t *bytes, uint8_t length) const;

 private:
  static const uint16_t NO_BYTE = 0x100;

  // As readByte(), and NO_BYTE beside it where a symbol is not in the table.
  uint16_t byte(uint8_t index) const;
};

}  // namespace javinolib
