#pragma once

#include <stdint.h>

#include "../Config.h"

namespace javinolib {

/// The protocol's constants, named as in SPEC.md. Where Config.h sets a shorter longest message, what depends on it is
/// shorter too.

static const uint8_t PROTOCOL_VERSION = 1;
static const uint8_t HEADER_LENGTH = 10;
static const uint16_t MAX_MESSAGE_LENGTH = config::MAX_MESSAGE;
static const uint16_t MAX_FRAME_LENGTH = HEADER_LENGTH + MAX_MESSAGE_LENGTH;
static const uint8_t NONCE_LENGTH = 6;
static const uint8_t TAG_LENGTH = 8;
static const uint8_t PROOF_LENGTH = 8;

/// Beside a content, a poll reply of the longest message holds status, flags, and of a record M the head, number,
/// addresses and id (SPEC 4.3).
static const uint16_t MAX_CONTENT_LENGTH = MAX_MESSAGE_LENGTH - (1 + 1 + 3 + 1 + 4 + 4 + 3);

/// The bytes of a packet beside its message: sequence byte and header before, CRC behind it (SPEC 4.1).
static const uint8_t PACKET_OVERHEAD = 1 + HEADER_LENGTH + 2;
static const uint16_t MAX_PACKET_LENGTH = PACKET_OVERHEAD + MAX_MESSAGE_LENGTH;
static const uint16_t MIN_PACKET_LENGTH = 1 + HEADER_LENGTH + 2;

/// The bytes of a sealed message beside its content.
static const uint8_t SEAL_LENGTH = NONCE_LENGTH + TAG_LENGTH;

static_assert(MAX_MESSAGE_LENGTH != 511 || (MAX_CONTENT_LENGTH == 494 && MAX_PACKET_LENGTH == 524), "SPEC's table");
static_assert(MIN_PACKET_LENGTH == 13, "SPEC's table");

}  // namespace javinolib
