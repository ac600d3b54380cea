// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenario_fault.h"

#include <stdlib.h>
#include <string.h>

#include "scenario_board.h"

static const char *const FAULT_NAMES[] = {"reset", "unplug", "plug", "power-cut", "jam", NULL};

const char *fault_name(fault_kind kind) { return FAULT_NAMES[kind]; }

static int board_index(const scenario *s, const char *name) {
  for (size_t i = 0; i < s->board_count; i++)
    if (s->boards[i].name && strcmp(s->boards[i].name, name) == 0) return (int)i;
  return -1;
}

size_t board_read(const scenario *s, const json_node *object) {
  json_node board = json_member(object, "board");
  const char *name = json_string_value(board.value);
  int index = name ? board_index(s, name) : -1;
  if (index < 0) json_expected(&board, "the name of one of the boards");
  return index < 0 ? 0 : (size_t)index;
}

static void read_fault_board(fault_config *fault, const scenario *s, const json_node *node) {
  json_node board = json_member(node, "board");
  fault->board = board_read(s, node);
  if ((fault->kind == FAULT_UNPLUG || fault->kind == FAULT_PLUG) && !s->boards[fault->board].port)
    json_fail(&board, "\"%s\" has no \"port\" to %s", s->boards[fault->board].name, FAULT_NAMES[fault->kind]);
}

static double required_seconds(const json_node *object, const char *key) {
  json_node node = json_member(object, key);
  if (!json_given(&node)) json_expected(&node, "a number of seconds");
  return json_number(&node, 0, 1e9, 0);
}

static void read_eeprom_writes(fault_config *fault, const json_node *node) {
  json_node writes = json_member(node, "eepromWrites");
  if (!json_given(&writes)) return;
  json_int_t count = json_integer_value(writes.value);
  if (count < 1 || count > 1000000000) json_expected(&writes, "a whole number from 1 to 1000000000");
  fault->eeprom_writes = (unsigned)count;
}

static void read_jam(fault_config *fault, const json_node *node) {
  json_node position = json_member(node, "position");
  fault->has_position = json_given(&position);
  position_read(&position, &fault->x_m, &fault->y_m);
}

static bool check_keys(fault_kind kind, const json_node *node, bool at_once) {
  static const char *const BOARD_KEYS[] = {"do", "board", NULL};
  static const char *const CUT_KEYS[] = {"do", "board", "duration", NULL};
  static const char *const JAM_KEYS[] = {"do", "duration", "position", NULL};
  static const char *const BOARD_TIMED_KEYS[] = {"t", "do", "board", "after", NULL};
  static const char *const CUT_TIMED_KEYS[] = {"t", "do", "board", "after", "duration", "eepromWrites", NULL};
  static const char *const JAM_TIMED_KEYS[] = {"t", "do", "duration", "position", NULL};
  switch (kind) {
    case FAULT_JAM: return json_check_object(node, at_once ? JAM_KEYS : JAM_TIMED_KEYS);
    case FAULT_POWER_CUT: return json_check_object(node, at_once ? CUT_KEYS : CUT_TIMED_KEYS);
    default: return json_check_object(node, at_once ? BOARD_KEYS : BOARD_TIMED_KEYS);
  }
}

void fault_read(fault_config *fault, const scenario *s, const json_node *node, bool at_once) {
  json_node kind = json_member(node, "do");
  int choice = json_choice(&kind, FAULT_NAMES);
  if (!json_given(&kind)) json_expected(&kind, "\"reset\", \"unplug\", \"plug\", \"power-cut\" or \"jam\"");
  if (choice < 0) return;
  fault->kind = (fault_kind)choice;
  if (!check_keys(fault->kind, node, at_once)) return;
  json_node after = json_member(node, "after");
  if (!at_once) fault->t_s = required_seconds(node, "t");
  if (fault->kind == FAULT_JAM || fault->kind == FAULT_POWER_CUT)
    fault->duration_s = required_seconds(node, "duration");
  if (fault->kind == FAULT_JAM)
    read_jam(fault, node);
  else
    read_fault_board(fault, s, node);
  after_read(&after, s->boards[fault->board].model, &fault->after_pin, &fault->after_level);
  if (fault->kind == FAULT_POWER_CUT) read_eeprom_writes(fault, node);
}
