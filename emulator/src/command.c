// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hex.h"
#include "json_reader.h"
#include "scenario_board.h"
#include "scenario_fault.h"
#include "scenario_radio.h"
#include "scenario_world.h"

#define MAX_SPEED 100

static void read_move(command *c, const json_node *node, const scenario *s) {
  static const char *const KEYS[] = {"do", "board", "position", "heading", NULL};
  if (!json_check_object(node, KEYS)) return;
  json_node position = json_member(node, "position");
  json_node heading = json_member(node, "heading");
  c->board = board_read(s, node);
  if (!json_given(&position)) json_expected(&position, "a position [x, y] in metres");
  position_read(&position, &c->x_m, &c->y_m);
  c->heading_deg = heading_read(&heading, NAN);
}

static void read_obstacle(command *c, const json_node *node) {
  static const char *const KEYS[] = {"do", "name", "position", "radius", NULL};
  static const char *const REMOVE_KEYS[] = {"do", "name", "remove", NULL};
  json_node remove = json_member(node, "remove");
  json_node name = json_member(node, "name");
  c->remove = json_flag(&remove, false);
  if (!json_check_object(node, json_given(&remove) ? REMOVE_KEYS : KEYS)) return;
  if (json_given(&remove) && !c->remove) json_expected(&remove, "true");
  if (!c->remove) {
    obstacle_read(&c->obstacle, node);
    return;
  }
  c->obstacle.name = json_text(&name);
  if (!c->obstacle.name) json_expected(&name, "a text in quotes");
}

// Slower than that is no speed: the time that is due would exceed its type.
#define LEAST_SPEED 0.001

static double required_number(const json_node *object, const char *key, double max) {
  char expected[48];
  json_node node = json_member(object, key);
  snprintf(expected, sizeof expected, "a number from 0 to %g", max);
  if (!json_given(&node)) json_expected(&node, expected);
  return json_number(&node, 0, max, 0);
}

static void read_value(command *c, const json_node *node, double max) {
  static const char *const KEYS[] = {"do", "value", NULL};
  if (json_check_object(node, KEYS)) c->value = required_number(node, "value", max);
}

static void read_speed(command *c, const json_node *node) {
  read_value(c, node, MAX_SPEED);
  json_node value = json_member(node, "value");
  if (c->value > 0 && c->value < LEAST_SPEED) json_expected(&value, "0, which pauses, or 0.001 to 100");
}

static void read_sensor(command *c, const json_node *node, const scenario *s) {
  static const char *const KEYS[] = {"do", "board", "pin", "value", NULL};
  if (!json_check_object(node, KEYS)) return;
  c->board = board_read(s, node);
  const board_config *board = &s->boards[c->board];
  json_node pin_node = json_member(node, "pin");
  json_node value = json_member(node, "value");
  int pin = pin_read(&pin_node, board->model, -1);
  while (c->sensor < board->sensor_count && board->sensors[c->sensor].pin != pin) c->sensor++;
  if (c->sensor == board->sensor_count) {
    json_expected(&pin_node, "the pin of a sensor of this board (the echo pin of an hc-sr04)");
    return;
  }
  c->remove = json_is_null(value.value);
  if (!c->remove) c->value = required_number(node, "value", sensor_most(board->sensors[c->sensor].kind));
}

static void read_radio(const json_node *node) {
  static const char *const KEYS[] = {"do", RADIO_KEYS, NULL};
  radio_config any = {0};
  if (json_check_object(node, KEYS)) radio_change_read(&any, node);
}

void command_change_radio(const command *c, radio_config *radio) {
  json_reader reader = {0};
  json_node root = json_root(&reader, c->given);
  radio_change_read(radio, &root);
}

// A count that a packet tells, modulo LINE_HOPS.
static unsigned read_told(const json_node *send, const char *key, const char *what) {
  json_node node = json_member(send, key);
  json_int_t value = json_integer_value(node.value);
  if (json_given(&node) && (!json_is_integer(node.value) || value < 0 || value >= LINE_HOPS))
    json_fail(&node, "expected the %s, 0 to %d", what, LINE_HOPS - 1);
  return (unsigned)value;
}

static void read_send(command *c, const json_node *node) {
  static const char *const KEYS[] = {"do", "position", "payload", "flip", "hops", "distance", NULL};
  if (!json_check_object(node, KEYS)) return;
  json_node position = json_member(node, "position");
  json_node payload = json_member(node, "payload");
  json_node flip = json_member(node, "flip");
  json_node distance = json_member(node, "distance");
  if (!json_given(&position)) json_expected(&position, "a position [x, y] in metres");
  position_read(&position, &c->packet.x_m, &c->packet.y_m);
  int length = hex_read(c->packet.payload, sizeof c->packet.payload, json_string_value(payload.value));
  c->packet.length = length < 0 ? 0 : (size_t)length;
  if (length <= 0) json_expected(&payload, "1 to 77 bytes in hexadecimal digits");
  c->packet.path = read_told(node, "hops", "number of hops behind the packet");
  unsigned told = read_told(node, "distance", "distance that the packet tells");
  if (json_given(&distance)) c->packet.path += LINE_HOPS * (1 + told);
  if (!json_given(&flip) || json_failed(node->reader)) return;
  json_int_t bits = (json_int_t)(8 * c->packet.length), bit = json_integer_value(flip.value);
  if (json_is_integer(flip.value) && bit >= 0 && bit < bits)
    c->packet.payload[bit / 8] ^= (uint8_t)(1 << bit % 8);
  else
    json_fail(&flip, "expected the number of a bit of the payload, 0 to %d", (int)bits - 1);
}

// A state of one of a host's state machines: texts that are for the trace alone.
static void read_transition(const json_node *node) {
  static const char *const KEYS[] = {"do", "machine", "host", "peer", "id", "state", NULL};
  if (!json_check_object(node, KEYS)) return;
  for (const char *const *key = KEYS; *key; key++) {
    json_node text = json_member(node, *key);
    if (!json_is_string(text.value)) json_expected(&text, "a text in quotes");
  }
}

static void read(command *c, const json_node *node, const scenario *s) {
  // The faults, and the other kinds in their order.
  static const char *const NAMES[] = {"reset", "unplug", "plug",  "power-cut", "jam",  "move",       "obstacle",
                                      "light", "sensor", "radio", "speed",     "send", "transition", NULL};
  json_node name = json_member(node, "do");
  if (!json_is_object(node->value)) json_expected(node, "an object { … }");
  if (!json_given(&name)) json_expected(&name, "a command, for example \"reset\"");
  int choice = json_choice(&name, NAMES);
  if (choice < 0) return;
  c->kind = choice <= FAULT_JAM ? COMMAND_FAULT : (command_kind)(choice - FAULT_JAM);
  switch (c->kind) {
    case COMMAND_FAULT: fault_read(&c->fault, s, node, true); break;
    case COMMAND_MOVE: read_move(c, node, s); break;
    case COMMAND_OBSTACLE: read_obstacle(c, node); break;
    case COMMAND_LIGHT: read_value(c, node, sensor_most(SENSOR_LDR)); break;
    case COMMAND_SENSOR: read_sensor(c, node, s); break;
    case COMMAND_RADIO: read_radio(node); break;
    case COMMAND_SPEED: read_speed(c, node); break;
    case COMMAND_SEND: read_send(c, node); break;
    case COMMAND_TRANSITION: read_transition(node); break;
  }
}

int command_read(command *c, const char *line, size_t length, const scenario *s, char *error, size_t error_size) {
  json_error_t mistake;
  json_reader reader = {.file = "command", .whole = "the object"};
  memset(c, 0, sizeof *c);
  c->given = json_loadb(line, length, JSON_REJECT_DUPLICATES, &mistake);
  if (c->given) {
    json_node root = json_root(&reader, c->given);
    read(c, &root, s);
  } else {
    snprintf(reader.error, sizeof reader.error, "command: column %d: %s", mistake.column, mistake.text);
  }
  snprintf(error, error_size, "%s", reader.error);
  return json_failed(&reader) ? -1 : 0;
}

void command_release(command *c) {
  json_decref(c->given);
  free(c->obstacle.name);
}
