// SPDX-License-Identifier: GPL-3.0-or-later
// The surroundings of the boards: the vehicles that they drive, the obstacles in their way, and the light.
#ifndef JAVINO_WORLD_H
#define JAVINO_WORLD_H

#include <stdbool.h>
#include <stddef.h>

#include "clock.h"
#include "scenario.h"

// Vehicles, and boards on a path, move in steps of this length.
#define WORLD_STEP (10 * CYCLES_PER_MS)
// How often one that moves says where it is.
#define WORLD_PLACE_INTERVAL (50 * CYCLES_PER_MS)

typedef enum { MOTOR_LEFT, MOTOR_RIGHT } world_motor;

typedef struct {
  void *context;
  // How a motor of the board's vehicle turns now: 1 forward, 0 not at all, -1 backward.
  int (*motor)(void *context, size_t board, world_motor motor);
  // A board is elsewhere; `told` where the trace is to say so.
  void (*placed)(void *context, size_t board, bool told, cycles_t at);
} world_listener;

// A board, and the vehicle that it may be on.
typedef struct {
  double x_m, y_m;
  double heading_deg;  // 0…360
  bool moving;         // and has not said that it stopped
  cycles_t next_place;
  bool on_path;  // of the scenario, which ends when a command moves the board
} world_body;

typedef struct {
  const scenario *config;
  world_listener listener;
  double light;  // as an LDR measures it
  world_body *bodies;
  obstacle_config obstacles[MAX_OBSTACLES];
  size_t obstacle_count;
  cycles_t next_step;  // nothing moves before
} world;

// Returns 0, or -1 where the memory does not suffice.
int world_init(world *w, const scenario *config, world_listener listener);
void world_release(world *w);

// A motor of a vehicle was switched.
void world_wake(world *w, cycles_t at);

// Moves vehicles, and boards on their paths, up to `now`.
void world_advance(world *w, cycles_t now);

// Puts a board elsewhere.
void world_move(world *w, size_t board, double x_m, double y_m, double heading_deg, cycles_t now);

// Makes an obstacle, or changes the one of this name. Returns 0, or -1 where MAX_OBSTACLES are there.
int world_put_obstacle(world *w, const obstacle_config *obstacle);

// Returns 0, or -1 where there is none of this name.
int world_remove_obstacle(world *w, const char *name);

// The distance from the vehicle's nose to what is straight ahead, in metres; infinity where there is nothing.
double world_distance_m(const world *w, size_t board);

#endif
