#pragma once

#include <stdint.h>

#include "../framing/Frame.h"
#include "../radio/Radio.h"
#include "../support/Inlining.h"

namespace javinolib {

/// Bytes of a frame that a fragment holds where packets carry the most, as the ASK radio's do (SPEC 7.1).
static const uint8_t FRAGMENT_LENGTH = MAX_RADIO_PAYLOAD - HEADER_LENGTH;
static const uint8_t MAX_FRAGMENTS = 8;

static_assert(MAX_FRAME_LENGTH <= MAX_FRAGMENTS * FRAGMENT_LENGTH, "SPEC 7.1");

/// How a frame that is too long for one packet is cut (SPEC 7.1). `longest`: the most bytes of a fragment, 16…67, as the
/// radio carries ten more.
namespace fragments {

/// Added to the index of a fragment whose sender wants an answer.
static const uint8_t WANTS_ANSWER = 8;

/// The fragments of a frame; 1 where it travels whole, more than MAX_FRAGMENTS where it cannot.
/// @param frameLength 10…521 bytes
JAVINO_NOINLINE uint8_t count(Length frameLength, uint8_t longest);

/// The bytes of a frame that a fragment holds.
/// @param index 0…count() - 1
uint8_t length(Length frameLength, uint8_t index, uint8_t longest);

/// The bit of a fragment.
/// @param index 0…7
uint8_t bitOf(uint8_t index);

/// One bit for each of `count` fragments.
JAVINO_NOINLINE uint8_t all(uint8_t count);

/// Builds a fragment.
/// @param id 0…63
/// @param index with WANTS_ANSWER or without
/// @param into room for a fragment and its header
/// @return the fragment's length
uint8_t cut(const uint8_t *frame, Length frameLength, uint8_t id, uint8_t index, uint8_t longest, uint8_t *into);

/// The id digit in a fragment's address.
inline uint8_t idOf(const Address &fragment) { return static_cast<uint8_t>(fragment.member() >> 6); }

/// The index digit in a fragment's address, 0…63: those above 15 are no fragment's.
inline uint8_t indexOf(const Address &fragment) { return fragment.member() & 0x3F; }

}  // namespace fragments
}  // namespace javinolib
