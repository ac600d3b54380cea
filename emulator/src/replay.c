// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay.h"

#include <stdlib.h>
#include <string.h>

#include "emulation_command.h"
#include "hex.h"
#include "json_reader.h"
#include "record.h"
#include "scenario_fault.h"
#include "scenario_radio.h"
#include "whole_file.h"

// Returns the next line as JSON, NULL at the end of the file and after a mistake. A last line without its end was cut off
// with the run: the run ends before it.
static json_t *next_line(replay *r, json_reader *reader) {
  json_error_t mistake;
  ssize_t length = getline(&r->text, &r->capacity, r->file);
  if (length <= 0 || r->text[length - 1] != '\n') return NULL;
  size_t mark = ++r->line == 1 ? byte_order_mark(r->text, (size_t)length) : 0;
  json_t *value = json_loadb(r->text + mark, (size_t)length - mark, JSON_REJECT_DUPLICATES, &mistake);
  if (!value)
    snprintf(reader->error, sizeof reader->error, "%s: line %u, column %d: %s", r->path, r->line, mistake.column,
             mistake.text);
  return value;
}

// Adds the number of the line to a mistake that the reader has found.
static int finish(const replay *r, const json_reader *reader, char *error, size_t error_size) {
  if (!json_failed(reader)) return 0;
  snprintf(error, error_size, "%.600s (line %u)", reader->error, r->line);
  return -1;
}

static void read_board(replay *r, const scenario *s, const json_node *node, size_t index) {
  json_node name = json_member(node, "name");
  json_node eeprom = json_member(node, "eeprom");
  const char *text = json_string_value(name.value);
  const char *hex = json_string_value(eeprom.value);
  size_t size = (size_t)s->boards[index].model->eeprom_size;
  if (!text || strcmp(text, s->boards[index].name) != 0)
    json_fail(&name, "the scenario has \"%s\" there; expected the scenario of the recorded run", s->boards[index].name);
  if (!hex) json_expected(&eeprom, "bytes in hexadecimal digits");
  if (!hex || !*hex) return;
  r->eeproms[index] = malloc(size);
  if (r->eeproms[index] && hex_read(r->eeproms[index], size, hex) != (int)size)
    json_fail(&eeprom, "expected %zu bytes in hexadecimal digits", size);
}

static void read_header(replay *r, scenario *s, const json_node *root) {
  static const char *const KEYS[] = {"record", "seed", "radio", "boards", NULL};
  if (!json_check_object(root, KEYS)) return;
  json_node version = json_member(root, "record");
  json_node seed = json_member(root, "seed");
  json_node radio = json_member(root, "radio");
  json_node boards = json_member(root, "boards");
  if (json_integer_value(version.value) != RECORD_VERSION) json_expected(&version, "1, as this emulator writes it");
  const char *digits = json_string_value(seed.value);
  char *end = NULL;
  if (digits) r->seed = strtoull(digits, &end, 10);
  if (!end || end == digits || *end) json_expected(&seed, "a number in quotes");
  radio_config_read(&s->radio, &radio);
  if (json_array_length(&boards) != s->board_count)
    json_fail(&boards, "the scenario has %zu; expected the scenario of the recorded run", s->board_count);
  for (size_t i = 0; i < s->board_count && !json_failed(root->reader); i++) {
    json_node board = json_element(&boards, i);
    read_board(r, s, &board, i);
  }
}

int replay_open(replay *r, const char *path, scenario *s, char *error, size_t error_size) {
  json_reader reader = {.file = path, .whole = "the first line"};
  const char *why;
  *r = (replay){.path = path, .file = open_to_read(path, &why)};
  if (!r->file) {
    snprintf(error, error_size, "--replay %s: %s", path, why);
    return -1;
  }
  json_t *value = next_line(r, &reader);
  json_node root = json_root(&reader, value);
  if (!json_failed(&reader)) read_header(r, s, &root);
  json_decref(value);
  return finish(r, &reader, error, error_size);
}

void replay_close(replay *r) {
  if (r->file) fclose(r->file);
  for (size_t i = 0; i < MAX_BOARDS; i++) free(r->eeproms[i]);
  free(r->text);
}

static void exchange_if_due(replay *r, emulation *e) {
  if (r->exchange_due) emulation_exchange(e);
  r->exchange_due = false;
}

static void run(replay *r, emulation *e, const json_node *until) {
  json_int_t cycle = json_integer_value(until->value);
  if (cycle < 0 || (cycles_t)cycle < e->now) json_expected(until, "a later cycle than that of the line before");
  exchange_if_due(r, e);
  if (json_failed(until->reader)) return;
  if (emulation_run(e, (cycles_t)cycle) != 0)
    snprintf(until->reader->error, sizeof until->reader->error, "%s", e->error);
  r->exchange_due = true;
}

static void set_port(emulation *e, const json_node *node) {
  static const char *const CHANGES[] = {"same", "open", "closed", NULL};
  uint8_t bytes[PTY_BUFFER];
  json_node port = json_member(node, "port");
  json_node in = json_member(node, "in");
  json_node out = json_member(node, "out");
  size_t board = board_read(e->config, node);
  int change = json_choice(&port, CHANGES);
  int length = hex_read(bytes, sizeof bytes, json_string_value(in.value));
  json_int_t gave = json_integer_value(out.value);
  if (json_failed(node->reader)) return;
  if (change < 0 || length < 0 || gave < 0 ||
      pty_play(&e->nodes[board].port, (pty_change)change, bytes, (size_t)length, (size_t)gave) != 0)
    json_fail(node,
              "no host can have done this here; expected the scenario, firmware and emulator of the recorded run");
}

static void exchange(replay *r, emulation *e, const json_node *ports) {
  for (size_t i = 0; i < json_array_length(ports); i++) {
    json_node port = json_element(ports, i);
    set_port(e, &port);
  }
  if (json_failed(ports->reader)) return;
  emulation_exchange(e);
  r->exchange_due = false;
}

// Performs a command anew. One that was refused then is refused again.
static void perform(replay *r, emulation *e, const json_node *given) {
  char error[512];
  char *line = json_dumps(given->value, JSON_COMPACT);
  command c;
  exchange_if_due(r, e);
  if (command_read(&c, line ? line : "", line ? strlen(line) : 0, e->config, error, sizeof error) == 0)
    emulation_command(e, &c, error, sizeof error);
  else
    json_fail(given, "%s", error);
  command_release(&c);
  free(line);
}

int replay_step(replay *r, emulation *e, char *error, size_t error_size) {
  static const char *const KEYS[] = {"run", "exchange", "command", NULL};
  json_reader reader = {.file = r->path, .whole = "the object"};
  json_t *value = next_line(r, &reader);
  json_node root = json_root(&reader, value);
  if (!value && !json_failed(&reader)) {
    exchange_if_due(r, e);
    return 0;
  }
  json_node until = json_member(&root, "run");
  json_node ports = json_member(&root, "exchange");
  json_node given = json_member(&root, "command");
  if (value) json_check_object(&root, KEYS);
  if (!json_failed(&reader) && json_given(&until)) run(r, e, &until);
  if (!json_failed(&reader) && json_given(&ports)) exchange(r, e, &ports);
  if (!json_failed(&reader) && json_given(&given)) perform(r, e, &given);
  json_decref(value);
  return finish(r, &reader, error, error_size) == 0 ? 1 : -1;
}
