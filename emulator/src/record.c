// SPDX-License-Identifier: GPL-3.0-or-later
#include "record.h"

#include "emulation.h"
#include "paths.h"
#include "scenario_radio.h"

int record_open(record *r, const char *path) {
  *r = (record){0};
  if (!path) return 0;
  int descriptor = open_private(path, false);
  if (descriptor >= 0) r->file = fdopen(descriptor, "w");
  return r->file ? 0 : -1;
}

int record_close(record *r) {
  if (!r->file) return 0;
  bool failed = record_failed(r);
  return fclose(r->file) == 0 && !failed ? 0 : -1;
}

bool record_failed(const record *r) { return r->file && ferror(r->file); }

static void write_hex(FILE *file, const uint8_t *bytes, size_t length) {
  for (size_t i = 0; i < length; i++) fprintf(file, "%02x", bytes[i]);
}

static void write_json(FILE *file, const json_t *value) { json_dumpf(value, file, JSON_COMPACT | JSON_ENCODE_ANY); }

static void write_text(FILE *file, const char *text) {
  json_t *value = json_string(text);
  write_json(file, value);
  json_decref(value);
}

void record_start(record *r, const emulation *e, uint64_t seed) {
  if (!r->file) return;
  fprintf(r->file, "{\"record\":%d,\"seed\":\"%llu\",\"radio\":", RECORD_VERSION, (unsigned long long)seed);
  json_t *radio = radio_config_json(&e->config->radio);
  write_json(r->file, radio);
  json_decref(radio);
  fputs(",\"boards\":[", r->file);
  for (size_t i = 0; i < e->node_count; i++) {
    const node *n = &e->nodes[i];
    fputs(i ? ",{\"name\":" : "{\"name\":", r->file);
    write_text(r->file, n->config->name);
    fputs(",\"eeprom\":\"", r->file);
    if (n->eeprom.live) write_hex(r->file, n->eeprom.live, (size_t)n->eeprom.size);
    fputs("\"}", r->file);
  }
  fputs("]}\n", r->file);
}

void record_run(record *r, cycles_t until) {
  if (r->file) fprintf(r->file, "{\"run\":%llu}\n", (unsigned long long)until);
}

void record_port(record *r, const char *board, const pty *port, pty_change change) {
  static const char *const CHANGES[] = {"same", "open", "closed"};
  if (!r->file || (change == PTY_SAME && port->got + port->gave == 0)) return;
  fputs(r->in_exchange ? "," : "{\"exchange\":[", r->file);
  r->in_exchange = true;
  fputs("{\"board\":", r->file);
  write_text(r->file, board);
  fprintf(r->file, ",\"port\":\"%s\",\"in\":\"", CHANGES[change]);
  write_hex(r->file, port->in + port->in_end - port->got, port->got);
  fprintf(r->file, "\",\"out\":%zu}", port->gave);
}

void record_exchange_end(record *r) {
  if (r->in_exchange) fputs("]}\n", r->file);
  r->in_exchange = false;
}

void record_command(record *r, const json_t *given) {
  if (!r->file) return;
  fputs("{\"command\":", r->file);
  write_json(r->file, given);
  fputs("}\n", r->file);
}
