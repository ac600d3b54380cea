#pragma once

#include <stdint.h>

#include "../radio/Radio.h"

namespace javino {

/// The protocol's constants, named as in SPEC.md.

static const uint8_t PROTOCOL_VERSION = 1;
static const uint8_t HEADER_LENGTH = 10;
static const uint16_t MAX_MESSAGE_LENGTH = 511;
static const uint16_t MAX_FRAME_LENGTH = HEADER_LENGTH + MAX_MESSAGE_LENGTH;
static const uint8_t NONCE_LENGTH = 6;
static const uint8_t TAG_LENGTH = 8;
static const uint16_t MAX_CONTENT_LENGTH = MAX_MESSAGE_LENGTH - NONCE_LENGTH - TAG_LENGTH;

/// Sequence byte before, CRC after the frame (SPEC 4.1).
static const uint16_t MAX_PACKET_LENGTH = 1 + MAX_FRAME_LENGTH + 2;
static const uint16_t MIN_PACKET_LENGTH = 1 + HEADER_LENGTH + 2;

/// What a sealed message is longer than its content.
static const uint8_t SEAL_LENGTH = NONCE_LENGTH + TAG_LENGTH;

/// The contents that fit one radio packet (SPEC 3).
static const uint8_t MAX_PLAIN_RADIO_CONTENT = MAX_RADIO_PAYLOAD - HEADER_LENGTH;
static const uint8_t MAX_SEALED_RADIO_CONTENT = MAX_PLAIN_RADIO_CONTENT - SEAL_LENGTH;

static_assert(MAX_CONTENT_LENGTH == 497 && MAX_PACKET_LENGTH == 524 && MIN_PACKET_LENGTH == 13, "SPEC's table");
static_assert(MAX_PLAIN_RADIO_CONTENT == 67 && MAX_SEALED_RADIO_CONTENT == 53, "SPEC 3");

}  // namespace javino
