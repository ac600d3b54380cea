// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_code.h"

#include <string.h>

// 0x38 and 0x2C, six bits each, least significant bit first.
#define START_SYMBOL (0x38u | 0x2Cu << 6)
#define WINDOW_BITS 12
#define WINDOW_MASK 0xFFFu
#define SYMBOL_BITS 6
#define SYMBOL_MASK 0x3Fu
#define TRAINING_SYMBOL 0x2Au
#define TRAINING_SYMBOLS 6
// The bits from the first carrier of the training to the end of the start symbol: the first bit is a 0.
#define LEAD_BITS 47
// The first byte of a trailer (SPEC 6.1), the first bit lowest; then the lengths of a trailer.
#define MARK_WORD (0x1Cu | 0x23u << 6)
#define PARITY_WORD (0x23u | 0x1Cu << 6)
#define LESS_PARITY_BYTES 12u
#define PARITY_BYTES 16u
#define MAX_COUNT_OF_LESS_PARITY 48
// Symbols that may be broken off at the end: boards may still find the right ones of two, of three never (SPEC 6).
#define MENDED_SYMBOLS 2
// A receiver tells a packet so many bits behind it. Silence is no trailer by its third bit; so its sender has told it
// before, even where a receiver reads half a bit early.
#define TELLING_BITS 4

static const uint8_t SYMBOLS[16] = {0x0D, 0x0E, 0x13, 0x15, 0x16, 0x19, 0x1A, 0x1C,
                                    0x23, 0x25, 0x26, 0x29, 0x2A, 0x2C, 0x32, 0x34};

// Trailers have another symbol in the place of one.
#define NO_TRAILER_SYMBOL 0x16u
#define TRAILER_SYMBOL 0x07u

static int nibble_of(unsigned symbol) {
  for (int nibble = 0; nibble < 16; nibble++)
    if (SYMBOLS[nibble] == symbol) return nibble;
  return -1;
}

void line_decoder_init(line_decoder *decoder, double bit_rate, line_listener listener) {
  memset(decoder, 0, sizeof *decoder);
  decoder->listener = listener;
  decoder->bit_cycles = CYCLES_PER_SECOND / bit_rate;
  decoder->idle_bits = LINE_IDLE_BITS;
}

static void fail(line_decoder *decoder, line_error error) {
  decoder->receiving = false;
  decoder->listener.damaged(decoder->listener.context, error, (cycles_t)decoder->next_sample);
}

// The end of the bit that is being taken.
static cycles_t bit_end(const line_decoder *decoder) {
  return (cycles_t)(decoder->next_sample + decoder->bit_cycles / 2);
}

// The value that the CRC is XORed with.
static uint16_t crc_of_path(unsigned path) { return (uint16_t)(path ^ path << 4 ^ path << 11); }

static void finish_packet(line_decoder *decoder) {
  size_t checked = decoder->byte_count - 2;
  uint16_t crc = (uint16_t)(decoder->bytes[checked] | decoder->bytes[checked + 1] << 8);
  uint16_t right = crc_x25(decoder->bytes, checked);
  unsigned path = 0;
  while (path < LINE_PATHS && crc != (right ^ crc_of_path(path))) path++;
  if (path == LINE_PATHS) {
    fail(decoder, LINE_BAD_CRC);
    return;
  }
  decoder->receiving = false;
  decoder->following = true;
  size_t length = checked - 1;
  decoder->packet = (line_packet){.payload = decoder->bytes + 1,
                                  .length = length,
                                  .path = path,
                                  .trailer = LINE_NO_TRAILER,
                                  .bits = (unsigned)(LINE_FRAMING_BITS + LINE_BITS_PER_BYTE * length),
                                  .start = decoder->start > 0 ? (cycles_t)decoder->start : 0,
                                  .end = bit_end(decoder)};
  if (decoder->listener.whole) decoder->listener.whole(decoder->listener.context, &decoder->packet);
}

void line_decoder_end(line_decoder *decoder) {
  if (!decoder->following) return;
  decoder->following = false;
  decoder->bit_count = 0;
  decoder->listener.ended(decoder->listener.context, &decoder->packet);
}

static bool is_trailer_symbol(unsigned symbol) {
  return symbol == TRAILER_SYMBOL || (symbol != NO_TRAILER_SYMBOL && nibble_of(symbol) >= 0);
}

static unsigned trailer_bits(const line_decoder *decoder) {
  if (decoder->packet.trailer == LINE_MARK) return WINDOW_BITS;
  return WINDOW_BITS * (1 + (decoder->bytes[0] <= MAX_COUNT_OF_LESS_PARITY ? LESS_PARITY_BYTES : PARITY_BYTES));
}

static void add_to_packet(line_decoder *decoder, unsigned bits) {
  decoder->packet.bits += bits;
  decoder->packet.end = bit_end(decoder);
  if (decoder->bit_count == trailer_bits(decoder)) line_decoder_end(decoder);
}

// The trailer's first byte. Its first symbol tells which it is: the sender may be reset before the second has ended.
static void take_trailer_word(line_decoder *decoder) {
  unsigned to_come = WINDOW_BITS - decoder->bit_count;
  unsigned sent = (unsigned)decoder->window >> to_come;
  bool mark = sent == (MARK_WORD & WINDOW_MASK >> to_come);
  bool parity = sent == (PARITY_WORD & WINDOW_MASK >> to_come);
  if (!mark && !parity) {
    line_decoder_end(decoder);
  } else if (decoder->bit_count % SYMBOL_BITS == 0) {
    decoder->packet.trailer = mark ? LINE_MARK : LINE_PARITY;
    add_to_packet(decoder, SYMBOL_BITS);
  }
}

// The last bit is one behind a whole packet.
static void follow(line_decoder *decoder) {
  decoder->bit_count++;
  if (!decoder->at_sender) {
    if (decoder->bit_count == TELLING_BITS) line_decoder_end(decoder);
  } else if (decoder->bit_count <= WINDOW_BITS) {
    take_trailer_word(decoder);
  } else if (decoder->bit_count % SYMBOL_BITS == 0) {
    if (is_trailer_symbol(decoder->window >> SYMBOL_BITS))
      add_to_packet(decoder, SYMBOL_BITS);
    else
      line_decoder_end(decoder);
  }
}

// A nibble of the CRC at the end of a packet, by the bytes before it; -1 elsewhere. A board that is reset may break off
// there.
static int mended(line_decoder *decoder, unsigned shift) {
  const size_t count = decoder->bytes[0];
  if (!decoder->at_sender || decoder->byte_count + 2 < LINE_MIN_COUNT || decoder->byte_count + 2 < count) return -1;
  if (decoder->mended++ == MENDED_SYMBOLS) return -1;
  const uint16_t crc = crc_x25(decoder->bytes, count - 2);
  return crc >> (decoder->byte_count + 1 == count ? 8 : 0) >> shift & 0xF;
}

static void take_byte(line_decoder *decoder) {
  int high = nibble_of(decoder->window & 0x3F);
  int low = nibble_of(decoder->window >> 6);
  if (high < 0) high = mended(decoder, 4);
  if (low < 0) low = mended(decoder, 0);
  if (high < 0 || low < 0) {
    fail(decoder, LINE_BAD_SYMBOL);
    return;
  }
  decoder->bytes[decoder->byte_count++] = (uint8_t)(high << 4 | low);
  uint8_t count = decoder->bytes[0];
  if (count < LINE_MIN_COUNT || count > LINE_MAX_COUNT)
    fail(decoder, LINE_BAD_COUNT);
  else if (decoder->byte_count == count)
    finish_packet(decoder);
}

static void take_bit(line_decoder *decoder, bool bit) {
  decoder->window = (uint16_t)(decoder->window >> 1 | (unsigned)bit << (WINDOW_BITS - 1));
  if (decoder->following) {
    follow(decoder);
    return;
  }
  if (!decoder->receiving) {
    decoder->receiving = decoder->window == START_SYMBOL;
    // The training tells the start, not the carrier: that may have been another packet's, close before.
    decoder->start = decoder->next_sample - (LEAD_BITS - 0.5) * decoder->bit_cycles;
    decoder->bit_count = 0;
    decoder->byte_count = 0;
    decoder->mended = 0;
    return;
  }
  if (++decoder->bit_count == WINDOW_BITS) {
    decoder->bit_count = 0;
    take_byte(decoder);
  }
}

void line_decoder_advance(line_decoder *decoder, cycles_t now) {
  while (decoder->next_sample < (double)now) {
    if (decoder->level) {
      decoder->idle_bits = 0;
    } else if (decoder->idle_bits >= LINE_IDLE_BITS && !decoder->receiving && !decoder->following) {
      // Silence says nothing new: the next edge tells where the bits are.
      decoder->next_sample = (double)now;
      return;
    } else {
      decoder->idle_bits++;
    }
    take_bit(decoder, decoder->level);
    decoder->next_sample += decoder->bit_cycles;
  }
}

void line_decoder_edge(line_decoder *decoder, bool level, cycles_t at) {
  line_decoder_advance(decoder, at);
  if (level == decoder->level) return;
  decoder->level = level;
  // Each edge is the border of two bits, and puts the sampling back into their middle.
  decoder->next_sample = (double)at + decoder->bit_cycles / 2;
}

static size_t put_symbol(uint8_t *bits, unsigned symbol) {
  for (int bit = 0; bit < SYMBOL_BITS; bit++) bits[bit] = symbol >> bit & 1;
  return SYMBOL_BITS;
}

size_t line_encode(uint8_t *bits, const uint8_t *payload, size_t length, unsigned path) {
  uint8_t bytes[LINE_MAX_COUNT];
  size_t count = length + 3;
  size_t written = 0;
  bytes[0] = (uint8_t)count;
  memcpy(bytes + 1, payload, length);
  uint16_t crc = (uint16_t)(crc_x25(bytes, count - 2) ^ crc_of_path(path));
  bytes[count - 2] = (uint8_t)crc;
  bytes[count - 1] = (uint8_t)(crc >> 8);
  for (int i = 0; i < TRAINING_SYMBOLS; i++) written += put_symbol(bits + written, TRAINING_SYMBOL);
  written += put_symbol(bits + written, START_SYMBOL & SYMBOL_MASK);
  written += put_symbol(bits + written, START_SYMBOL >> SYMBOL_BITS);
  for (size_t i = 0; i < count; i++) {
    written += put_symbol(bits + written, SYMBOLS[bytes[i] >> 4]);
    written += put_symbol(bits + written, SYMBOLS[bytes[i] & 0xF]);
  }
  return written;
}

const char *line_trailer_text(line_trailer trailer) {
  static const char *const TEXTS[] = {NULL, "mark", "parity"};
  return TEXTS[trailer];
}

const char *line_error_text(line_error error) {
  static const char *const TEXTS[] = {"wrong symbol", "wrong count", "wrong CRC"};
  return TEXTS[error];
}

uint16_t crc_x25(const uint8_t *bytes, size_t length) {
  uint16_t crc = 0xFFFF;
  for (size_t i = 0; i < length; i++) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; bit++) crc = (uint16_t)(crc & 1 ? crc >> 1 ^ 0x8408 : crc >> 1);
  }
  return (uint16_t)~crc;
}
