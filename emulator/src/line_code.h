// SPDX-License-Identifier: GPL-3.0-or-later
// The line code of SPEC section 6, read off a level: on-off keying, training, start symbol,
// 6-bit symbols, count, CRC. Written for the sniffer; shares nothing with the firmware.
#ifndef JAVINO_LINE_CODE_H
#define JAVINO_LINE_CODE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clock.h"

#define LINE_MIN_COUNT 4
#define LINE_MAX_COUNT 80
#define LINE_MAX_PAYLOAD (LINE_MAX_COUNT - 3)
// The silence after which the next carrier begins a new packet.
#define LINE_IDLE_BITS 16
// SPEC 6: n bytes of payload take 84 + 12 n bits.
#define LINE_FRAMING_BITS 84
#define LINE_BITS_PER_BYTE 12
#define LINE_MAX_BITS (LINE_FRAMING_BITS + LINE_BITS_PER_BYTE * LINE_MAX_PAYLOAD)

// Hops and distances are told modulo this.
#define LINE_HOPS 4
#define LINE_PATHS (LINE_HOPS * (1 + LINE_HOPS))

// The trailer that may follow a packet (SPEC 6.1).
typedef enum { LINE_NO_TRAILER, LINE_MARK, LINE_PARITY } line_trailer;

typedef enum { LINE_BAD_SYMBOL, LINE_BAD_COUNT, LINE_BAD_CRC } line_error;

typedef struct {
  const uint8_t *payload;
  size_t length;
  unsigned path;  // hops behind it, and 4 + 4 a more if it tells the distance a
  line_trailer trailer;
  unsigned bits;   // with the trailer's
  cycles_t start;  // first carrier of the training
  cycles_t end;    // end of the last bit
} line_packet;

typedef struct {
  void *context;
  // The CRC is right; a trailer may follow. May be NULL.
  void (*whole)(void *context, const line_packet *packet);
  // The packet has ended, and its trailer too; told up to four bits later.
  void (*ended)(void *context, const line_packet *packet);
  void (*damaged)(void *context, line_error error, cycles_t at);
} line_listener;

typedef struct {
  line_listener listener;
  double bit_cycles;
  bool level;
  double next_sample;  // cycle at which the level is read next: the middle of a bit
  // Whether the level is a sender's own. Then a trailer is read, as far as it was sent. And a packet counts though its
  // last two symbols were cut short, as when its sender lost its power: boards mend them, so that they may have it.
  // False unless it is set after line_decoder_init(): at a receiver a packet ends with its CRC.
  bool at_sender;
  unsigned idle_bits;  // zeros in a row, up to LINE_IDLE_BITS
  double start;        // of the packet being received, in cycles
  uint16_t window;     // the last 12 bits, first one lowest
  bool receiving;      // the start symbol has been seen
  bool following;      // the packet is whole, and may have a trailer
  unsigned bit_count;  // bits of the current byte, 0…11; of all that follows the packet
  uint8_t bytes[LINE_MAX_COUNT];
  size_t byte_count;
  unsigned mended;     // symbols of its CRC
  line_packet packet;  // the last whole one
} line_decoder;

void line_decoder_init(line_decoder *decoder, double bit_rate, line_listener listener);

// The level changes at `at`, which must not lie before the last call's time.
void line_decoder_edge(line_decoder *decoder, bool level, cycles_t at);

// Nothing else happens before `now`.
void line_decoder_advance(line_decoder *decoder, cycles_t now);

// Nothing comes any more: a whole packet ends here.
void line_decoder_end(line_decoder *decoder);

// Writes the bits, 0 or 1 each, with which 1 to LINE_MAX_PAYLOAD bytes are sent, with a path below LINE_PATHS.
// Returns their number.
size_t line_encode(uint8_t *bits, const uint8_t *payload, size_t length, unsigned path);

// The trailer's name in the trace; NULL for none.
const char *line_trailer_text(line_trailer trailer);

// The error's name in the trace.
const char *line_error_text(line_error error);

// CRC-16/X-25, which packets on the air and on the serial line end with (SPEC 4.1), low byte first.
uint16_t crc_x25(const uint8_t *bytes, size_t length);

#endif
