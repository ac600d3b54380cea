// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenario_world.h"

#include <stdlib.h>
#include <string.h>

#include "scenario_board.h"

#define MAX_LIGHT 1023
#define DEFAULT_LIGHT 700
#define MIN_RADIUS_M 0.01
#define MAX_RADIUS_M 1000

double light_read(const json_node *node, double otherwise) { return json_number(node, 0, MAX_LIGHT, otherwise); }

void obstacle_read(obstacle_config *obstacle, const json_node *node) {
  json_node name = json_member(node, "name");
  json_node position = json_member(node, "position");
  json_node radius = json_member(node, "radius");
  obstacle->name = json_text(&name);
  if (!obstacle->name) json_expected(&name, "a text in quotes");
  if (!json_given(&position)) json_expected(&position, "a position [x, y] in metres");
  position_read(&position, &obstacle->x_m, &obstacle->y_m);
  if (!json_given(&radius)) json_expected(&radius, "a number of metres");
  obstacle->radius_m = json_number(&radius, MIN_RADIUS_M, MAX_RADIUS_M, 0);
}

static void read_obstacles(world_config *world, const json_node *node) {
  static const char *const KEYS[] = {"name", "position", "radius", NULL};
  size_t count = json_array_length(node);
  if (count > MAX_OBSTACLES) json_expected(node, "a list of at most 64 obstacles");
  world->obstacles = calloc(count + 1, sizeof *world->obstacles);
  for (; world->obstacle_count < count && !json_failed(node->reader); world->obstacle_count++) {
    json_node obstacle = json_element(node, world->obstacle_count);
    if (json_check_object(&obstacle, KEYS)) obstacle_read(&world->obstacles[world->obstacle_count], &obstacle);
    for (size_t i = 0; i < world->obstacle_count && !json_failed(node->reader); i++)
      if (strcmp(world->obstacles[i].name, world->obstacles[world->obstacle_count].name) == 0)
        json_fail(&obstacle, "has the name of obstacles[%zu]; expected one of its own", i);
  }
}

void world_config_read(world_config *world, const json_node *node) {
  static const char *const KEYS[] = {"light", "obstacles", NULL};
  if (json_given(node) && !json_check_object(node, KEYS)) return;
  json_node light = json_member(node, "light");
  json_node obstacles = json_member(node, "obstacles");
  world->light = light_read(&light, DEFAULT_LIGHT);
  read_obstacles(world, &obstacles);
}

void world_config_release(world_config *world) {
  for (size_t i = 0; i < world->obstacle_count; i++) free(world->obstacles[i].name);
  free(world->obstacles);
}
