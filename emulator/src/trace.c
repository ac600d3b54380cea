// SPDX-License-Identifier: GPL-3.0-or-later
#include "trace.h"

#include <math.h>
#include <string.h>

static bool writing(const trace *t) { return t->file && !t->failed; }

static void write_quoted(FILE *file, const uint8_t *bytes, size_t length) {
  fputc('"', file);
  for (size_t i = 0; i < length; i++) {
    if (bytes[i] == '"' || bytes[i] == '\\')
      fprintf(file, "\\%c", bytes[i]);
    else if (bytes[i] < 0x20 || bytes[i] == 0x7F)
      fprintf(file, "\\u%04x", bytes[i]);
    else
      fputc(bytes[i], file);
  }
  fputc('"', file);
}

static void write_key(FILE *file, const char *key) { fprintf(file, ",\"%s\":", key); }

void trace_begin(trace *t, cycles_t at, const char *board, const char *event) {
  if (!writing(t)) return;
  fprintf(t->file, "{\"t\":%.6f", cycles_to_seconds(at));
  if (board) trace_text(t, "board", board);
  trace_text(t, "event", event);
}

void trace_end(trace *t) {
  if (!writing(t)) return;
  fputs("}\n", t->file);
  fflush(t->file);
  t->failed = ferror(t->file) != 0;
}

void trace_text(trace *t, const char *key, const char *value) {
  trace_utf8(t, key, (const uint8_t *)value, strlen(value));
}

void trace_utf8(trace *t, const char *key, const uint8_t *bytes, size_t length) {
  if (!writing(t)) return;
  write_key(t->file, key);
  write_quoted(t->file, bytes, length);
}

void trace_hex(trace *t, const char *key, const uint8_t *bytes, size_t length) {
  if (!writing(t)) return;
  write_key(t->file, key);
  fputc('"', t->file);
  for (size_t i = 0; i < length; i++) fprintf(t->file, "%02x", bytes[i]);
  fputc('"', t->file);
}

void trace_count(trace *t, const char *key, uint64_t value) {
  if (!writing(t)) return;
  write_key(t->file, key);
  fprintf(t->file, "%llu", (unsigned long long)value);
}

void trace_flag(trace *t, const char *key, bool value) {
  if (!writing(t)) return;
  write_key(t->file, key);
  fputs(value ? "true" : "false", t->file);
}

void trace_json(trace *t, const char *key, const json_t *value) {
  if (!writing(t)) return;
  write_key(t->file, key);
  json_dumpf(value, t->file, JSON_COMPACT | JSON_ENCODE_ANY | JSON_REAL_PRECISION(15));
}

// Thousandths will do, and no -0.
static void write_number(FILE *file, double value) { fprintf(file, "%.12g", round(1000 * value) / 1000 + 0.0); }

void trace_number(trace *t, const char *key, double value) {
  if (!writing(t)) return;
  write_key(t->file, key);
  write_number(t->file, value);
}

void trace_numbers(trace *t, const char *key, const double *values, size_t count) {
  if (!writing(t)) return;
  write_key(t->file, key);
  for (size_t i = 0; i < count; i++) {
    fputc(i ? ',' : '[', t->file);
    write_number(t->file, values[i]);
  }
  fputc(']', t->file);
}

void trace_time(trace *t, const char *key, cycles_t at) {
  if (!writing(t)) return;
  write_key(t->file, key);
  fprintf(t->file, "%.6f", cycles_to_seconds(at));
}

void trace_list_begin(trace *t, const char *key) {
  if (!writing(t)) return;
  write_key(t->file, key);
  fputc('[', t->file);
}

void trace_list_utf8(trace *t, const uint8_t *bytes, size_t length, bool first) {
  if (!writing(t)) return;
  if (!first) fputc(',', t->file);
  write_quoted(t->file, bytes, length);
}

void trace_list_text(trace *t, const char *value, bool first) {
  trace_list_utf8(t, (const uint8_t *)value, strlen(value), first);
}

void trace_list_end(trace *t) {
  if (writing(t)) fputc(']', t->file);
}
