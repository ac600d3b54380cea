// SPDX-License-Identifier: GPL-3.0-or-later
#include "intel_hex.h"

#include <string.h>

#include "hex.h"

// Length, address (2), type, at most 255 bytes of data, checksum.
#define HEAD 4
#define LONGEST (HEAD + 255 + 1)

enum { DATA, END, SEGMENT, START_SEGMENT, LINEAR, START_LINEAR };

typedef struct {
  const uint8_t *bytes;
  size_t length, at;
} reader;

bool intel_hex_begins(const uint8_t *bytes, size_t length) { return length > 0 && bytes[0] == ':'; }

static bool is_space(uint8_t byte) { return byte == '\n' || byte == '\r' || byte == ' ' || byte == '\t'; }

static bool read_byte(reader *r, uint8_t *byte) {
  if (r->length - r->at < 2) return false;
  int high = hex_digit((char)r->bytes[r->at]), low = hex_digit((char)r->bytes[r->at + 1]);
  r->at += 2;
  if (high < 0 || low < 0) return false;
  *byte = (uint8_t)(high << 4 | low);
  return true;
}

// Reads the next record, whose bytes add up to 0.
static bool read_record(reader *r, uint8_t *record) {
  uint8_t sum = 0;
  while (r->at < r->length && is_space(r->bytes[r->at])) r->at++;
  if (r->at == r->length || r->bytes[r->at++] != ':') return false;
  record[0] = 0;
  for (size_t i = 0; i < (size_t)HEAD + record[0] + 1; i++) {
    if (!read_byte(r, &record[i])) return false;
    sum = (uint8_t)(sum + record[i]);
  }
  return sum == 0;
}

static bool copy(const uint8_t *record, uint32_t at, hex_target *target) {
  uint32_t length = record[0];
  if (at < target->first || at > target->limit || length > target->limit - at) return false;
  memcpy(target->memory + at, record + HEAD, length);
  if (at < target->lowest) target->lowest = at;
  if (at + length > target->end) target->end = at + length;
  return true;
}

bool intel_hex_copy(const uint8_t *bytes, size_t length, hex_target *target) {
  reader r = {bytes, length, 0};
  uint8_t record[LONGEST] = {0};
  uint32_t base = 0;
  target->lowest = target->limit;
  target->end = 0;
  while (read_record(&r, record)) {
    uint32_t at = (uint32_t)record[1] << 8 | record[2], operand = (uint32_t)record[HEAD] << 8 | record[HEAD + 1];
    switch (record[3]) {
      case DATA:
        if (!copy(record, base + at, target)) return false;
        break;
      case END: return target->end > 0;
      case SEGMENT:
      case LINEAR:
        if (record[0] != 2) return false;
        base = record[3] == SEGMENT ? operand << 4 : operand << 16;
        break;
      case START_SEGMENT:
      case START_LINEAR:  // where a program begins: an AVR does so at its reset
        break;
      default: return false;
    }
  }
  return false;
}
