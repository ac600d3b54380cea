// SPDX-License-Identifier: GPL-3.0-or-later
// The trace: one JSON object a line, flushed line by line so that a reader can follow it live.
#ifndef JAVINO_TRACE_H
#define JAVINO_TRACE_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "clock.h"

typedef struct {
  FILE *file;   // NULL: events are not written
  bool failed;  // a line could not be written; nothing is written after it
} trace;

// An event is written as trace_begin, any number of fields, trace_end.
// `board` may be NULL for events of no single board.
void trace_begin(trace *t, cycles_t at, const char *board, const char *event);
void trace_end(trace *t);

void trace_text(trace *t, const char *key, const char *value);
void trace_utf8(trace *t, const char *key, const uint8_t *bytes, size_t length);
void trace_hex(trace *t, const char *key, const uint8_t *bytes, size_t length);
void trace_count(trace *t, const char *key, uint64_t value);
void trace_flag(trace *t, const char *key, bool value);
void trace_json(trace *t, const char *key, const json_t *value);
void trace_number(trace *t, const char *key, double value);
void trace_numbers(trace *t, const char *key, const double *values, size_t count);
void trace_time(trace *t, const char *key, cycles_t at);

// A list of texts, given one by one.
void trace_list_begin(trace *t, const char *key);
void trace_list_utf8(trace *t, const uint8_t *bytes, size_t length, bool first);
void trace_list_text(trace *t, const char *value, bool first);
void trace_list_end(trace *t);

#endif
