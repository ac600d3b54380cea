// SPDX-License-Identifier: GPL-3.0-or-later
#include "emulation_command.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Does the part that may be refused, and writes no events. Returns what was wrong, NULL if nothing was.
static const char *prepare(emulation *e, const command *c) {
  switch (c->kind) {
    case COMMAND_FAULT:
      return c->fault.kind == FAULT_JAM &&
                     rf_bus_jam_now(&e->air, &c->fault, e->now, e->now + seconds_to_cycles(c->fault.duration_s)) != 0
                 ? "too many jams at one time; wait until one has ended"
                 : NULL;
    case COMMAND_OBSTACLE:
      if (c->remove)
        return world_remove_obstacle(&e->surroundings, c->obstacle.name) == 0 ? NULL
                                                                              : "there is no obstacle of this name";
      return world_put_obstacle(&e->surroundings, &c->obstacle) == 0 ? NULL
                                                                     : "there are 64 obstacles; remove one first";
    case COMMAND_SEND:
      return (e->modules.modules ? serial_modules_inject(&e->modules, &c->packet, e->now)
                                 : injector_send(&e->injector, &c->packet, e->now)) == 0
                 ? NULL
                 : "16 packets wait to be sent; send this one when some of them are out";
    default: return NULL;
  }
}

static void write_event(emulation *e, const command *c) {
  bool of_host = c->kind == COMMAND_TRANSITION;
  const char *board = json_string_value(json_object_get(c->given, "board"));
  const char *key;
  json_t *value;
  trace_begin(e->out, e->now, board, of_host ? "transition" : "command");
  if (!of_host) trace_count(e->out, "cycle", e->now);
  json_object_foreach(c->given, key, value) {
    if (strcmp(key, of_host ? "do" : "board") != 0) trace_json(e->out, key, value);
  }
  trace_end(e->out);
}

static void move(emulation *e, const command *c) {
  double heading_deg = isnan(c->heading_deg) ? e->surroundings.bodies[c->board].heading_deg : c->heading_deg;
  world_move(&e->surroundings, c->board, c->x_m, c->y_m, heading_deg, e->now);
}

static void set_sensor(emulation *e, const command *c) {
  sensor *s = &e->nodes[c->board].sensors[c->sensor];
  if (c->remove)
    sensor_release(s);
  else
    sensor_hold(s, c->value);
}

static void set_radio(emulation *e, const command *c) {
  radio_config radio = e->air.radio;
  command_change_radio(c, &radio);
  rf_bus_set_radio(&e->air, &radio, e->now);
}

int emulation_command(emulation *e, const command *c, char *error, size_t error_size) {
  const char *wrong = prepare(e, c);
  if (wrong) {
    snprintf(error, error_size, "command: %s", wrong);
    return -1;
  }
  write_event(e, c);
  switch (c->kind) {
    case COMMAND_FAULT:
      if (emulation_fault(e, &c->fault) == 0) return 0;
      snprintf(error, error_size, "command: %s", e->error);
      return -1;
    case COMMAND_MOVE: move(e, c); break;
    case COMMAND_LIGHT: e->surroundings.light = c->value; break;
    case COMMAND_SENSOR: set_sensor(e, c); break;
    case COMMAND_RADIO: set_radio(e, c); break;
    case COMMAND_SPEED: e->speed_asked = c->value; break;
    case COMMAND_OBSTACLE:
    case COMMAND_SEND:
    case COMMAND_TRANSITION: break;
  }
  return 0;
}
