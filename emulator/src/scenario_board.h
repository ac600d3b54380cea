// SPDX-License-Identifier: GPL-3.0-or-later
// The `boards` part of the scenario file.
#ifndef JAVINO_SCENARIO_BOARD_H
#define JAVINO_SCENARIO_BOARD_H

#include "json_reader.h"
#include "scenario.h"

// Reads one board; mistakes are recorded in the reader of `node`.
void board_config_read(board_config *board, const json_node *node, const char *scenario_directory,
                       const char *directory);

void board_config_release(board_config *board);

// The sensor's type in the file.
const char *sensor_name(sensor_kind kind);

// The most that a sensor of this kind can measure.
double sensor_most(sensor_kind kind);

// Reads a pin, or `otherwise` where the value is absent; -1 as `otherwise` makes it necessary.
int pin_read(const json_node *node, const model *m, int otherwise);

// Reads degrees, or `otherwise` where the value is absent.
double heading_read(const json_node *node, double otherwise);

// Reads {"pin", "level"} of a model; the pin is -1 where it is absent.
void after_read(const json_node *node, const model *m, int *pin, int *level);

// Reads [x, y], in metres.
void position_read(const json_node *node, double *x_m, double *y_m);

#endif
