// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_code.h"

#include <string.h>

// 0x38 and 0x2C, six bits each, least significant bit first.
#define START_SYMBOL (0x38u | 0x2Cu << 6)
#define WINDOW_BITS 12
#define SYMBOL_BITS 6
#define SYMBOL_MASK 0x3Fu
#define TRAINING_SYMBOL 0x2Au
#define TRAINING_SYMBOLS 6
// From the first carrier of the training to the end of the start symbol: the first bit is a 0.
#define LEAD_BITS 47

static const uint8_t SYMBOLS[16] = {0x0D, 0x0E, 0x13, 0x15, 0x16, 0x19, 0x1A, 0x1C,
                                    0x23, 0x25, 0x26, 0x29, 0x2A, 0x2C, 0x32, 0x34};

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

static void finish_packet(line_decoder *decoder) {
  size_t checked = decoder->byte_count - 2;
  uint16_t crc = (uint16_t)(decoder->bytes[checked] | decoder->bytes[checked + 1] << 8);
  if (crc != crc_x25(decoder->bytes, checked)) {
    fail(decoder, LINE_BAD_CRC);
    return;
  }
  decoder->receiving = false;
  line_packet packet = {decoder->bytes + 1, checked - 1, decoder->start > 0 ? (cycles_t)decoder->start : 0,
                        (cycles_t)(decoder->next_sample + decoder->bit_cycles / 2)};
  decoder->listener.packet(decoder->listener.context, &packet);
}

// The low nibble of a packet's last byte, by its CRC; -1 elsewhere.
static int mended_end(const line_decoder *decoder) {
  if (!decoder->mends_end || decoder->byte_count < LINE_MIN_COUNT - 1 || decoder->byte_count + 1 != decoder->bytes[0])
    return -1;
  return crc_x25(decoder->bytes, decoder->byte_count - 1) >> 8 & 0xF;
}

static void take_byte(line_decoder *decoder) {
  int high = nibble_of(decoder->window & 0x3F);
  int low = nibble_of(decoder->window >> 6);
  if (low < 0) low = mended_end(decoder);
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
  if (!decoder->receiving) {
    decoder->receiving = decoder->window == START_SYMBOL;
    // Not when the carrier came: it may have been another packet's, close before.
    decoder->start = decoder->next_sample - (LEAD_BITS - 0.5) * decoder->bit_cycles;
    decoder->bit_count = 0;
    decoder->byte_count = 0;
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
    } else if (decoder->idle_bits >= LINE_IDLE_BITS) {
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

void line_decoder_finish(line_decoder *decoder) {
  bool last_byte = decoder->byte_count > 0 && decoder->byte_count + 1 == decoder->bytes[0];
  if (decoder->receiving && last_byte && decoder->bit_count == WINDOW_BITS - 1)
    line_decoder_advance(decoder, (cycles_t)decoder->next_sample + 1);
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

size_t line_encode(uint8_t *bits, const uint8_t *payload, size_t length) {
  uint8_t bytes[LINE_MAX_COUNT];
  size_t count = length + 3;
  size_t written = 0;
  bytes[0] = (uint8_t)count;
  memcpy(bytes + 1, payload, length);
  uint16_t crc = crc_x25(bytes, count - 2);
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
