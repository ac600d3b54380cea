// SPDX-License-Identifier: GPL-3.0-or-later
// A command to a run under way: one line of the control socket, read and checked. emulator/README.md documents every
// key.
#ifndef JAVINO_COMMAND_H
#define JAVINO_COMMAND_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "scenario.h"
#include "injector.h"

typedef enum {
  COMMAND_FAULT,
  COMMAND_MOVE,
  COMMAND_OBSTACLE,
  COMMAND_LIGHT,
  COMMAND_SENSOR,
  COMMAND_RADIO,
  COMMAND_SPEED,
  COMMAND_SEND,
  COMMAND_TRANSITION
} command_kind;

typedef struct {
  json_t *given;  // the object that was read
  command_kind kind;
  fault_config fault;
  size_t board;              // move, sensor
  double x_m, y_m;           // move
  double heading_deg;        // move; NAN: stays as it is
  obstacle_config obstacle;  // obstacle; of one to be removed only the name
  bool remove;               // obstacle; or what the sensor was told to measure
  size_t sensor;             // the board's, by index
  double value;              // light, sensor, speed
  injector_packet packet;    // send
} command;

// Reads a line. Returns 0, or -1 with one line in `error`; release it either way.
int command_read(command *c, const char *line, size_t length, const scenario *s, char *error, size_t error_size);
void command_release(command *c);

// Applies a radio command to what the radio was.
void command_change_radio(const command *c, radio_config *radio);

#endif
