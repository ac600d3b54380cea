// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_log.h"

#include <string.h>

// Only the first bytes are told of a run that is longer than the two copies of a floor: only a key is as long, and they
// end before its secrets.
#define WHOLE 26
#define BEGINNING 8

#define POINT(name, first, second) name,
enum {
  NOTHING,
#include "TracePoints.h"
  END
};
#undef POINT

#define POINT(name, first, second) {#name, {#first, #second}},
static const struct {
  const char *name, *operands[2];
} POINTS[] = {
    {"", {"", ""}},
#include "TracePoints.h"
};
#undef POINT

void point_log_init(point_log *p, trace *out, const char *board, const uint64_t *heard, unsigned clock_cycles) {
  *p = (point_log){.out = out,
                   .board = board,
                   .heard = heard,
                   .late = (cycles_t)POINTS_LATE_CYCLES * clock_cycles,
                   .run = NEVER,
                   .turn = -1};
}

void point_log_reset(point_log *p) {
  p->run = NEVER;
  p->air = NOTHING;
  p->turn = -1;
  p->length = 0;
}

void point_log_flush(point_log *p, cycles_t now) {
  if (p->length == 0) return;
  trace_begin(p->out, now, p->board, "eeprom");
  trace_count(p->out, "at", p->at);
  trace_count(p->out, "length", p->length);
  trace_hex(p->out, "hex", p->bytes, p->length > WHOLE ? BEGINNING : p->length);
  trace_end(p->out);
  p->length = 0;
}

void point_log_eeprom(point_log *p, uint16_t address, uint8_t byte, cycles_t now) {
  bool before = p->length != 0 && address + 1 == p->at;
  if (!(before || address == p->at + p->length) || p->length == POINTS_LONGEST_RUN) {
    point_log_flush(p, now);
    before = false;
  }
  if (p->length == 0 || before) {
    memmove(p->bytes + 1, p->bytes, p->length);
    p->at = address;
  }
  p->bytes[before ? 0 : p->length] = byte;
  p->length++;
}

// Whether a run() is told: the first, a late one, and each that finds the air otherwise than the one before.
static bool begin_run(point_log *p, uint8_t air, cycles_t now) {
  p->gap = p->run == NEVER ? 0 : now - p->run;
  p->run = now;
  bool told = air != p->air || p->gap > p->late;
  p->air = air;
  return told;
}

void point_log_tell(point_log *p, uint8_t number, uint8_t first, uint8_t second, cycles_t now) {
  if (number == NOTHING || number >= END) return;
  point_log_flush(p, now);
  if ((number == QUIET || number == BUSY) && !begin_run(p, number, now)) return;
  if (number == TURN && first == p->turn) return;
  if (number == TURN) p->turn = first;
  trace_begin(p->out, now, p->board, "point");
  trace_text(p->out, "name", POINTS[number].name);
  if (*POINTS[number].operands[0]) trace_count(p->out, POINTS[number].operands[0], first);
  if (*POINTS[number].operands[1]) trace_count(p->out, POINTS[number].operands[1], second);
  if (number != QUIET && number != BUSY && number != TURN && *p->heard != 0) trace_count(p->out, "packet", *p->heard);
  if (p->run != NEVER) {
    trace_time(p->out, "run", p->run);
    trace_time(p->out, "gap", p->gap);
  }
  trace_end(p->out);
}
