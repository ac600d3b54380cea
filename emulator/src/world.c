// SPDX-License-Identifier: GPL-3.0-or-later
#include "world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FULL_TURN_DEG 360

typedef struct {
  double x, y;
} vector;

static double normal_deg(double degrees) {
  double rest = fmod(degrees, FULL_TURN_DEG);
  return rest < 0 ? rest + FULL_TURN_DEG : rest;
}

static vector direction(double heading_deg) {
  double radians = heading_deg * M_PI / (FULL_TURN_DEG / 2);
  return (vector){cos(radians), sin(radians)};
}

static const vehicle_config *vehicle(const world *w, size_t board) { return &w->config->boards[board].vehicle; }

static bool is_vehicle(const world *w, size_t board) { return vehicle(w, board)->radius_m > 0; }

typedef struct {
  double x_m, y_m, radius_m;
} circle;

static size_t circle_count(const world *w) { return w->obstacle_count + w->config->board_count; }

// The obstacles, then the vehicles. Returns whether the one of this number can be in a board's way.
static bool circle_read(circle *c, const world *w, size_t board, size_t number) {
  if (number < w->obstacle_count) {
    const obstacle_config *obstacle = &w->obstacles[number];
    *c = (circle){obstacle->x_m, obstacle->y_m, obstacle->radius_m};
    return true;
  }
  size_t other = number - w->obstacle_count;
  *c = (circle){w->bodies[other].x_m, w->bodies[other].y_m, vehicle(w, other)->radius_m};
  return other != board && is_vehicle(w, other);
}

// How far a point can go in a direction until it is at the circle; infinity where it does not meet it.
static double way_to_circle(const world_body *from, vector along, const circle *c, double margin_m) {
  double x = c->x_m - from->x_m, y = c->y_m - from->y_m, radius_m = c->radius_m + margin_m;
  double ahead = x * along.x + y * along.y;
  double beside = x * along.y - y * along.x;
  if (ahead <= 0 || fabs(beside) >= radius_m) return INFINITY;
  return fmax(0, ahead - sqrt(radius_m * radius_m - beside * beside));
}

// How far a board's centre can go until what is `margin_m` around it touches something.
static double free_way(const world *w, size_t board, vector along, double margin_m) {
  double way = INFINITY;
  circle c;
  for (size_t i = 0; i < circle_count(w); i++)
    if (circle_read(&c, w, board, i)) way = fmin(way, way_to_circle(&w->bodies[board], along, &c, margin_m));
  return way;
}

int world_init(world *w, const scenario *config, world_listener listener) {
  memset(w, 0, sizeof *w);
  w->config = config;
  w->listener = listener;
  w->light = config->world.light;
  w->next_step = NEVER;
  w->bodies = calloc(config->board_count, sizeof *w->bodies);
  if (!w->bodies) return -1;
  for (size_t i = 0; i < config->board_count; i++) {
    const board_config *board = &config->boards[i];
    w->bodies[i] =
        (world_body){.x_m = board->x_m, .y_m = board->y_m, .heading_deg = normal_deg(board->vehicle.heading_deg)};
    w->bodies[i].on_path = board->path_x.count > 0;
    if (w->bodies[i].on_path) world_wake(w, 0);
  }
  for (size_t i = 0; i < config->world.obstacle_count; i++)
    if (world_put_obstacle(w, &config->world.obstacles[i]) != 0) return -1;
  return 0;
}

void world_release(world *w) {
  for (size_t i = 0; i < w->obstacle_count; i++) free(w->obstacles[i].name);
  free(w->bodies);
}

void world_wake(world *w, cycles_t at) {
  if (w->next_step == NEVER) w->next_step = (at / WORLD_STEP + 1) * WORLD_STEP;
}

// Moves as motors on both sides do. Returns whether the place or the heading is another one.
static bool drive(world *w, size_t board, int left, int right) {
  const vehicle_config *config = vehicle(w, board);
  world_body *body = &w->bodies[board];
  world_body before = *body;
  double each_m = config->speed_m_s * cycles_to_seconds(WORLD_STEP);
  double way_m = each_m * (left + right) / 2;
  // The motors are as far apart as the vehicle is wide.
  double turn_deg = each_m * (right - left) / (2 * config->radius_m) * (FULL_TURN_DEG / 2) / M_PI;
  vector along = direction(body->heading_deg + (way_m < 0 ? FULL_TURN_DEG / 2 : 0));
  double length_m = fmin(fabs(way_m), free_way(w, board, along, config->radius_m));
  body->x_m += length_m * along.x;
  body->y_m += length_m * along.y;
  body->heading_deg = normal_deg(body->heading_deg + turn_deg);
  return length_m > 0 || body->heading_deg != before.heading_deg;
}

static void tell(world *w, size_t board, bool moved, cycles_t now) {
  world_body *body = &w->bodies[board];
  bool told = moved ? now >= body->next_place : body->moving;
  if (told) body->next_place = now + WORLD_PLACE_INTERVAL;
  body->moving = moved;
  if (moved || told) w->listener.placed(w->listener.context, board, told, now);
}

// Returns whether a motor turns.
static bool step(world *w, size_t board, cycles_t now) {
  int left = w->listener.motor(w->listener.context, board, MOTOR_LEFT);
  int right = w->listener.motor(w->listener.context, board, MOTOR_RIGHT);
  tell(w, board, drive(w, board, left, right), now);
  return left != 0 || right != 0;
}

// Returns whether there is more to come.
static bool follow_path(world *w, size_t board, cycles_t now) {
  const board_config *config = &w->config->boards[board];
  world_body *body = &w->bodies[board];
  world_body before = *body;
  double seconds = cycles_to_seconds(now);
  body->x_m = series_linear(&config->path_x, seconds);
  body->y_m = series_linear(&config->path_y, seconds);
  bool moved = body->x_m != before.x_m || body->y_m != before.y_m;
  tell(w, board, moved, now);
  return moved || isfinite(series_next_change_s(&config->path_x, seconds));
}

void world_advance(world *w, cycles_t now) {
  while (w->next_step <= now) {
    bool moving = false;
    for (size_t i = 0; i < w->config->board_count; i++) {
      if (is_vehicle(w, i)) moving |= step(w, i, now);
      if (w->bodies[i].on_path) moving |= follow_path(w, i, now);
    }
    w->next_step = moving ? w->next_step + WORLD_STEP : NEVER;
  }
}

void world_move(world *w, size_t board, double x_m, double y_m, double heading_deg, cycles_t now) {
  world_body *body = &w->bodies[board];
  body->on_path = false;
  body->x_m = x_m;
  body->y_m = y_m;
  body->heading_deg = normal_deg(heading_deg);
  w->listener.placed(w->listener.context, board, true, now);
}

static size_t find_obstacle(const world *w, const char *name) {
  size_t index = 0;
  while (index < w->obstacle_count && strcmp(w->obstacles[index].name, name) != 0) index++;
  return index;
}

int world_put_obstacle(world *w, const obstacle_config *obstacle) {
  size_t index = find_obstacle(w, obstacle->name);
  if (index == MAX_OBSTACLES) return -1;
  char *name = index < w->obstacle_count ? w->obstacles[index].name : strdup(obstacle->name);
  if (!name) return -1;
  w->obstacles[index] = *obstacle;
  w->obstacles[index].name = name;
  w->obstacle_count += index == w->obstacle_count;
  return 0;
}

int world_remove_obstacle(world *w, const char *name) {
  size_t index = find_obstacle(w, name);
  if (index == w->obstacle_count) return -1;
  free(w->obstacles[index].name);
  w->obstacle_count--;
  memmove(&w->obstacles[index], &w->obstacles[index + 1], (w->obstacle_count - index) * sizeof *w->obstacles);
  return 0;
}

// Whether a vehicle's nose is inside of something: then that has no edge ahead.
static bool is_covered(const world *w, size_t board) {
  const world_body *body = &w->bodies[board];
  vector along = direction(body->heading_deg);
  double nose_m = vehicle(w, board)->radius_m;
  circle c;
  for (size_t i = 0; i < circle_count(w); i++)
    if (circle_read(&c, w, board, i) &&
        hypot(c.x_m - body->x_m - nose_m * along.x, c.y_m - body->y_m - nose_m * along.y) < c.radius_m)
      return true;
  return false;
}

double world_distance_m(const world *w, size_t board) {
  if (is_covered(w, board)) return 0;
  return fmax(0, free_way(w, board, direction(w->bodies[board].heading_deg), 0) - vehicle(w, board)->radius_m);
}
