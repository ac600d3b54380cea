#pragma once

#include "Bytes.h"

/// The serial packet of SPEC 4.1, written from its definition, bit by bit and independently of the firmware.
namespace reference {

uint16_t crc(const Bytes &bytes);
Bytes cobs(const Bytes &bytes);
/// Throws where the bytes are no COBS.
Bytes cobsDecoded(const Bytes &bytes);

/// Sequence byte, frame and CRC in COBS, with the closing 0x00.
Bytes packet(uint8_t sequence, const Bytes &frame);

/// destination, origin, size and message.
Bytes frame(const std::string &destination, const std::string &origin, const Bytes &message);

}  // namespace reference
