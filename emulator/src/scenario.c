// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenario.h"

#include <errno.h>
#include <jansson.h>
#include <libgen.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "json_reader.h"
#include "scenario_board.h"
#include "scenario_fault.h"
#include "scenario_radio.h"
#include "scenario_world.h"
#include "whole_file.h"

static bool same_text(const char *a, const char *b) { return a && b && strcmp(a, b) == 0; }

// A path from a place in it that a slash is before, without what leads nowhere.
static const char *skip_here(const char *path) {
  while (path[0] == '/' || (path[0] == '.' && path[1] == '/')) path++;
  return path;
}

static bool same_path(const char *a, const char *b) {
  if (!a || !b || (*a == '/') != (*b == '/')) return false;
  a = skip_here(a);
  b = skip_here(b);
  while (*a && *a == *b) {
    bool folder_ends = *a == '/';
    a++;
    b++;
    if (folder_ends) {
      a = skip_here(a);
      b = skip_here(b);
    }
  }
  return *a == *b;
}

// No two boards share a name, a port or an EEPROM file; each firmware and boot loader is readable.
static void check_board(const scenario *s, size_t index, const json_node *node) {
  const board_config *board = &s->boards[index];
  json_node firmware = json_member(node, "firmware");
  json_node boot_loader = json_member(node, "bootLoader");
  for (size_t i = 0; i < index; i++) {
    const char *shared = same_text(board->name, s->boards[i].name)       ? "name"
                         : same_path(board->port, s->boards[i].port)     ? "port"
                         : same_text(board->eeprom, s->boards[i].eeprom) ? "eeprom"
                                                                         : NULL;
    if (shared) {
      json_node value = json_member(node, shared);
      json_fail(&value, "is the same as that of boards[%zu]; expected one of its own", i);
    }
  }
  if (s->radio.module.name && board->model != &MEGA) {
    json_node chosen = json_member(node, "model");
    json_fail(&chosen, "has no second UART for the radio's module; expected \"mega\"");
  }
  if (board->firmware && access(board->firmware, R_OK) != 0)
    json_fail(&firmware, "cannot read %s (%s); build the firmware or correct the path", board->firmware,
              strerror(errno));
  if (board->boot_loader && access(board->boot_loader, R_OK) != 0)
    json_fail(&boot_loader, "cannot read %s (%s); install arduino-core-avr or correct the path", board->boot_loader,
              strerror(errno));
}

static void read_boards(scenario *s, const json_node *node, const char *scenario_directory, const char *directory) {
  size_t count = json_array_length(node);
  if (count == 0 || count > MAX_BOARDS) {
    json_expected(node, "a list of 1 to 48 boards");
    return;
  }
  s->boards = calloc(count, sizeof *s->boards);
  for (; s->board_count < count && !json_failed(node->reader); s->board_count++) {
    json_node board = json_element(node, s->board_count);
    board_config_read(&s->boards[s->board_count], &board, scenario_directory, directory);
    check_board(s, s->board_count, &board);
  }
}

static int by_time(const void *a, const void *b) {
  double first = ((const fault_config *)a)->t_s;
  double second = ((const fault_config *)b)->t_s;
  return (first > second) - (first < second);
}

static void read_faults(scenario *s, const json_node *node) {
  size_t count = json_array_length(node);
  s->faults = calloc(count + 1, sizeof *s->faults);
  for (; s->fault_count < count && !json_failed(node->reader); s->fault_count++) {
    json_node fault = json_element(node, s->fault_count);
    fault_read(&s->faults[s->fault_count], s, &fault, false);
  }
  qsort(s->faults, s->fault_count, sizeof *s->faults, by_time);
}

// Puts "radio.key=value" into the JSON as if the file had said it, to be checked with the rest.
static void apply_override(json_reader *reader, json_t *root, const char *override) {
  static const char PREFIX[] = "radio.";
  const char *equals = strchr(override, '=');
  json_t *value = equals ? json_loads(equals + 1, JSON_DECODE_ANY, NULL) : NULL;
  if (!value || strncmp(override, PREFIX, sizeof PREFIX - 1) != 0) {
    snprintf(reader->error, sizeof reader->error,
             "--set %.100s: expected radio.key=number, e.g. radio.bitErrorRate=0.001", override);
    json_decref(value);
    return;
  }
  char key[64];
  const char *start = override + sizeof PREFIX - 1;
  snprintf(key, sizeof key, "%.*s", (int)(equals - start), start);
  if (!json_object_get(root, "radio")) json_object_set_new(root, "radio", json_object());
  json_object_set_new(json_object_get(root, "radio"), key, value);
}

static void read_root(scenario *s, const json_node *root, const scenario_context *context) {
  static const char *const KEYS[] = {"radio", "boards", "faults", "world", NULL};
  if (!json_check_object(root, KEYS)) return;
  for (size_t i = 0; i < context->override_count; i++) apply_override(root->reader, root->value, context->overrides[i]);
  json_node radio = json_member(root, "radio");
  json_node boards = json_member(root, "boards");
  json_node faults = json_member(root, "faults");
  char *file = strdup(root->reader->file);
  json_node world = json_member(root, "world");
  radio_config_read(&s->radio, &radio);
  world_config_read(&s->world, &world);
  read_boards(s, &boards, dirname(file), context->directory);
  if (!json_failed(root->reader)) read_faults(s, &faults);
  free(file);
}

int scenario_load(scenario *result, const char *path, const scenario_context *context, char *error, size_t error_size) {
  memset(result, 0, sizeof *result);
  json_reader reader = {.file = path};
  json_error_t mistake;
  whole_file file;
  const char *why;
  int unread = whole_file_read(&file, path, &why);
  size_t mark = unread ? 0 : byte_order_mark(file.bytes, file.length);
  json_t *value =
      unread ? NULL : json_loadb((char *)file.bytes + mark, file.length - mark, JSON_REJECT_DUPLICATES, &mistake);
  whole_file_release(&file);
  if (unread)
    snprintf(reader.error, sizeof reader.error, "%s: cannot read the scenario: %s", path, why);
  else if (!value)
    snprintf(reader.error, sizeof reader.error, "%s: line %d, column %d: %s", path, mistake.line, mistake.column,
             mistake.text);
  if (value) {
    json_node root = json_root(&reader, value);
    read_root(result, &root, context);
    json_decref(value);
  }
  snprintf(error, error_size, "%s", reader.error);
  return json_failed(&reader) ? -1 : 0;
}

void scenario_release(scenario *result) {
  for (size_t i = 0; i < result->board_count; i++) board_config_release(&result->boards[i]);
  free(result->boards);
  free(result->faults);
  world_config_release(&result->world);
  memset(result, 0, sizeof *result);
}
