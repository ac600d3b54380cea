// SPDX-License-Identifier: GPL-3.0-or-later
// The `world` part of the scenario file.
#ifndef JAVINO_SCENARIO_WORLD_H
#define JAVINO_SCENARIO_WORLD_H

#include "json_reader.h"
#include "scenario.h"

// Reads the world; mistakes are recorded in the reader of `node`.
void world_config_read(world_config *world, const json_node *node);

void world_config_release(world_config *world);

// Reads name, position and radius of an object whose keys are checked. The name is to be freed after a mistake too.
void obstacle_read(obstacle_config *obstacle, const json_node *node);

// Reads the light that an LDR of the world measures, `otherwise` where it is absent.
double light_read(const json_node *node, double otherwise);

#endif
