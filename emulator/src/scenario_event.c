// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenario_event.h"

#include <jansson.h>
#include <stdio.h>
#include <string.h>

#include "scenario_board.h"
#include "scenario_radio.h"

// The version of the trace; in version 3 packets have numbers.
#define VERSION 3

static json_t *position(double x_m, double y_m) { return json_pack("[ff]", x_m, y_m); }

static json_t *pin(const model *m, int number) {
  return number < m->pin_a0 ? json_integer(number) : json_sprintf("A%d", number - m->pin_a0);
}

static json_t *sensors(const board_config *board) {
  json_t *list = json_array();
  for (size_t i = 0; i < board->sensor_count; i++)
    json_array_append_new(list, json_pack("{ssso}", "type", sensor_name(board->sensors[i].kind), "pin",
                                          pin(board->model, board->sensors[i].pin)));
  return list;
}

static json_t *watches(const board_config *board) {
  json_t *list = json_array();
  for (size_t i = 0; i < board->watch_count; i++)
    json_array_append_new(
        list, json_pack("{soss}", "pin", pin(board->model, board->watches[i].pin), "name", board->watches[i].name));
  return list;
}

static bool ends_in(const char *port, const char *name) {
  size_t length = strlen(port), end = strlen(name);
  return length == end ? strcmp(port, name) == 0
                       : length > end && port[length - end - 1] == '/' && strcmp(port + length - end, name) == 0;
}

// The port's name, with as much of its folder as distinguishes it: that of the run differs from run to run.
static const char *name_of(const char *port, const scenario *s) {
  const char *name = port + strlen(port);
  size_t same = 2;
  while (same > 1 && name > port) {
    for (name--; name > port && name[-1] != '/'; name--)
      ;
    same = 0;
    for (size_t i = 0; i < s->board_count; i++) same += s->boards[i].port && ends_in(s->boards[i].port, name);
  }
  return name;
}

static json_t *boards(const scenario *s) {
  json_t *list = json_array();
  for (size_t i = 0; i < s->board_count; i++) {
    const board_config *board = &s->boards[i];
    json_t *object = json_pack("{sssssososo}", "name", board->name, "model", board->model->name, "position",
                               position(board->x_m, board->y_m), "sensors", sensors(board), "watch", watches(board));
    if (board->port) json_object_set_new(object, "port", json_string(name_of(board->port, s)));
    if (board->clock_error_ppm) json_object_set_new(object, "clockError", json_integer(board->clock_error_ppm));
    if (board->vehicle.radius_m > 0) {
      json_object_set_new(object, "heading", json_real(board->vehicle.heading_deg));
      json_object_set_new(object, "radius", json_real(board->vehicle.radius_m));
    }
    json_array_append_new(list, object);
  }
  return list;
}

static json_t *world(const world_config *config) {
  json_t *obstacles = json_array();
  for (size_t i = 0; i < config->obstacle_count; i++) {
    const obstacle_config *obstacle = &config->obstacles[i];
    json_array_append_new(obstacles, json_pack("{sssosf}", "name", obstacle->name, "position",
                                               position(obstacle->x_m, obstacle->y_m), "radius", obstacle->radius_m));
  }
  return json_pack("{sfso}", "light", config->light, "obstacles", obstacles);
}

static void write_new(trace *out, const char *key, json_t *value) {
  trace_json(out, key, value);
  json_decref(value);
}

void scenario_event_write(trace *out, const scenario *s, uint64_t seed) {
  trace_begin(out, 0, NULL, "scenario");
  trace_count(out, "version", VERSION);
  trace_count(out, "seed", seed);
  write_new(out, "radio", radio_config_json(&s->radio));
  write_new(out, "boards", boards(s));
  write_new(out, "world", world(&s->world));
  trace_end(out);
}
