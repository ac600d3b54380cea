// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenario_board.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"

#define DEFAULT_TX_PIN 12
#define DEFAULT_RX_PIN 11
#define MAX_COORDINATE_M 1e6
#define MAX_DISTANCE_CM 10000
#define MAX_ADC_READING 1023
#define MIN_RADIUS_M 0.01
#define MAX_RADIUS_M 100
#define DEFAULT_RADIUS_M 1
#define MAX_SPEED_M_S 100
#define DEFAULT_SPEED_M_S 1
#define MAX_BRIDGE_LATENCY_MS 255
#define MAX_CLOCK_ERROR_PPM 50000

static const char *const SENSOR_TYPES[] = {"hc-sr04", "ldr", "digital", NULL};

const char *sensor_name(sensor_kind kind) { return SENSOR_TYPES[kind]; }

double sensor_most(sensor_kind kind) {
  return kind == SENSOR_HC_SR04 ? MAX_DISTANCE_CM : kind == SENSOR_LDR ? MAX_ADC_READING : 1;
}

int pin_read(const json_node *node, const model *m, int otherwise) {
  int pin = -1;
  if (!json_given(node) && otherwise >= 0) return otherwise;
  if (json_is_integer(node->value)) {
    json_int_t number = json_integer_value(node->value);
    pin = number >= 0 && number < m->pin_count ? (int)number : -1;
  } else if (json_is_string(node->value)) {
    pin = pin_parse(m, json_string_value(node->value));
  }
  if (pin < 0) {
    char expected[64];
    snprintf(expected, sizeof expected, "a pin: %s", m->pins);
    json_expected(node, expected);
  }
  return pin;
}

static int read_analog_pin(const json_node *node, const model *m) {
  int pin = pin_read(node, m, -1);
  if (!json_failed(node->reader) && !pin_is_analog(m, pin)) {
    char expected[64];
    snprintf(expected, sizeof expected, "an analog pin, %s", m->adc_pins);
    json_expected(node, expected);
  }
  return pin;
}

static char *join_path(const char *directory, char *path) {
  if (!path || path[0] == '/' || strcmp(directory, ".") == 0) return path;
  size_t size = strlen(directory) + strlen(path) + 2;
  char *joined = malloc(size);
  if (joined) snprintf(joined, size, "%s/%s", directory, path);
  free(path);
  return joined;
}

void position_read(const json_node *node, double *x_m, double *y_m) {
  if (!json_given(node)) return;
  if (json_array_length(node) != 2) {
    json_expected(node, "a position [x, y] in metres");
    return;
  }
  json_node x = json_element(node, 0);
  json_node y = json_element(node, 1);
  *x_m = json_number(&x, -MAX_COORDINATE_M, MAX_COORDINATE_M, 0);
  *y_m = json_number(&y, -MAX_COORDINATE_M, MAX_COORDINATE_M, 0);
}

static void read_point(series_point *point, const json_node *node, double max) {
  if (!json_is_array(node->value) || json_array_length(node) != 2) {
    json_expected(node, "a point [seconds, value]");
    return;
  }
  json_node time = json_element(node, 0);
  json_node value = json_element(node, 1);
  point->t_s = json_number(&time, 0, 1e9, 0);
  point->value = json_number(&value, 0, max, 0);
}

// Takes up a point as the next one of a series that has room.
static void add_point(series *values, const json_node *node, series_point point) {
  if (values->count > 0 && point.t_s <= values->points[values->count - 1].t_s)
    json_expected(node, "a later time than that of the point before");
  values->points[values->count++] = point;
}

static void read_series(series *values, const json_node *node, double max) {
  size_t count = json_array_length(node);
  if (count == 0) {
    json_expected(node, "a list of points [[seconds, value], …]");
    return;
  }
  values->points = calloc(count, sizeof *values->points);
  while (values->count < count) {
    json_node node_of_point = json_element(node, values->count);
    series_point point = {0};
    read_point(&point, &node_of_point, max);
    add_point(values, &node_of_point, point);
  }
}

// Reads as read_series does; the word "world" leaves the series empty.
static void read_series_or_world(series *values, const json_node *node, double max) {
  const char *text = json_string_value(node->value);
  if (text && strcmp(text, "world") == 0) return;
  if (json_is_array(node->value))
    read_series(values, node, max);
  else
    json_expected(node, "a list of points [[seconds, value], …], or \"world\"");
}

void after_read(const json_node *node, const model *m, int *pin, int *level) {
  static const char *const KEYS[] = {"pin", "level", NULL};
  *pin = -1;
  if (!json_given(node) || !json_check_object(node, KEYS)) return;
  json_node pin_node = json_member(node, "pin");
  json_node level_node = json_member(node, "level");
  *pin = pin_read(&pin_node, m, -1);
  *level = json_number(&level_node, 0, 1, 1) != 0;
}

static void read_hc_sr04(sensor_config *sensor, const model *m, const json_node *node) {
  static const char *const KEYS[] = {"type", "trigger", "echo", "distance", "noise", "after", NULL};
  if (!json_check_object(node, KEYS)) return;
  json_node trigger = json_member(node, "trigger");
  json_node echo = json_member(node, "echo");
  json_node distance = json_member(node, "distance");
  sensor->trigger = pin_read(&trigger, m, -1);
  sensor->pin = pin_read(&echo, m, -1);
  read_series_or_world(&sensor->values, &distance, sensor_most(SENSOR_HC_SR04));
}

static void read_ldr(sensor_config *sensor, const model *m, const json_node *node) {
  static const char *const KEYS[] = {"type", "pin", "light", "noise", "after", NULL};
  if (!json_check_object(node, KEYS)) return;
  json_node pin = json_member(node, "pin");
  json_node light = json_member(node, "light");
  sensor->pin = read_analog_pin(&pin, m);
  read_series_or_world(&sensor->values, &light, sensor_most(SENSOR_LDR));
}

static void read_digital(sensor_config *sensor, const model *m, const json_node *node) {
  static const char *const KEYS[] = {"type", "pin", "level", "after", NULL};
  if (!json_check_object(node, KEYS)) return;
  json_node pin = json_member(node, "pin");
  json_node level = json_member(node, "level");
  sensor->pin = pin_read(&pin, m, -1);
  read_series(&sensor->values, &level, sensor_most(SENSOR_DIGITAL));
}

static void read_sensor(sensor_config *sensor, const model *m, const json_node *node) {
  json_node type = json_member(node, "type");
  int kind = json_choice(&type, SENSOR_TYPES);
  if (!json_given(&type)) json_expected(&type, "\"hc-sr04\", \"ldr\" or \"digital\"");
  if (kind < 0) return;
  sensor->kind = (sensor_kind)kind;
  switch (sensor->kind) {
    case SENSOR_HC_SR04: read_hc_sr04(sensor, m, node); break;
    case SENSOR_LDR: read_ldr(sensor, m, node); break;
    case SENSOR_DIGITAL: read_digital(sensor, m, node); break;
  }
  json_node after = json_member(node, "after");
  json_node noise = json_member(node, "noise");
  sensor->noise = json_number(&noise, 0, sensor_most(sensor->kind), 0);
  after_read(&after, m, &sensor->after_pin, &sensor->after_level);
}

// No two sensors give one pin its level.
static void check_sensor_pin(const board_config *board, const json_node *node) {
  for (size_t i = 0; i < board->sensor_count; i++) {
    if (board->sensors[i].pin == board->sensors[board->sensor_count].pin)
      json_fail(node, "has the pin of sensors[%zu]; expected one of its own", i);
  }
}

static void read_sensors(board_config *board, const json_node *node) {
  size_t count = json_array_length(node);
  board->sensors = calloc(count + 1, sizeof *board->sensors);
  for (; board->sensor_count < count && !json_failed(node->reader); board->sensor_count++) {
    json_node sensor = json_element(node, board->sensor_count);
    read_sensor(&board->sensors[board->sensor_count], board->model, &sensor);
    check_sensor_pin(board, &sensor);
  }
}

static void read_watch(watch_config *watch, const model *m, const json_node *node) {
  static const char *const KEYS[] = {"pin", "name", NULL};
  if (!json_check_object(node, KEYS)) return;
  json_node pin = json_member(node, "pin");
  json_node name = json_member(node, "name");
  watch->pin = pin_read(&pin, m, -1);
  watch->name = json_text(&name);
  if (!watch->name) json_expected(&name, "a text in quotes");
}

static void check_watch(const board_config *board, const json_node *node) {
  const watch_config *last = &board->watches[board->watch_count];
  for (size_t i = 0; i < board->watch_count; i++) {
    const watch_config *other = &board->watches[i];
    if (other->pin == last->pin) json_fail(node, "has the pin of watch[%zu]; expected one of its own", i);
    if (last->name && other->name && strcmp(other->name, last->name) == 0)
      json_fail(node, "has the name of watch[%zu]; expected one of its own", i);
  }
}

static void read_watches(board_config *board, const json_node *node) {
  size_t count = json_array_length(node);
  board->watches = calloc(count + 1, sizeof *board->watches);
  for (; board->watch_count < count && !json_failed(node->reader); board->watch_count++) {
    json_node watch = json_element(node, board->watch_count);
    read_watch(&board->watches[board->watch_count], board->model, &watch);
    check_watch(board, &watch);
  }
}

static void read_motors(int *pins, const json_node *node, const model *m) {
  if (!json_is_array(node->value) || json_array_length(node) != 2) {
    json_expected(node, "two pins [left, right]");
    return;
  }
  for (size_t i = 0; i < 2; i++) {
    json_node pin = json_element(node, i);
    pins[i] = pin_read(&pin, m, -1);
  }
}

double heading_read(const json_node *node, double otherwise) { return json_number(node, -360, 360, otherwise); }

static void read_vehicle(vehicle_config *vehicle, const json_node *node, const model *m) {
  static const char *const KEYS[] = {"heading", "speed", "radius", "forward", "backward", NULL};
  if (!json_given(node) || !json_check_object(node, KEYS)) return;
  json_node heading = json_member(node, "heading");
  json_node speed = json_member(node, "speed");
  json_node radius = json_member(node, "radius");
  json_node forward = json_member(node, "forward");
  json_node backward = json_member(node, "backward");
  vehicle->heading_deg = heading_read(&heading, 0);
  vehicle->speed_m_s = json_number(&speed, 0, MAX_SPEED_M_S, DEFAULT_SPEED_M_S);
  vehicle->radius_m = json_number(&radius, MIN_RADIUS_M, MAX_RADIUS_M, DEFAULT_RADIUS_M);
  read_motors(vehicle->forward, &forward, m);
  read_motors(vehicle->backward, &backward, m);
}

// An ultrasonic sensor that has no series measures the world from a vehicle's nose on.
static void check_sonars(const board_config *board, const json_node *sensors) {
  for (size_t i = 0; i < board->sensor_count && board->vehicle.radius_m == 0; i++) {
    json_node sensor = json_element(sensors, i);
    if (board->sensors[i].kind == SENSOR_HC_SR04 && board->sensors[i].values.count == 0)
      json_fail(&sensor,
                "a distance in the world needs a vehicle; expected a \"vehicle\" of the board, or a list of points");
  }
}

static void read_path_point(board_config *board, const json_node *node) {
  double t_s, x_m = 0, y_m = 0;
  if (!json_is_array(node->value) || json_array_length(node) != 2) {
    json_expected(node, "a point [seconds, [x, y]]");
    return;
  }
  json_node time = json_element(node, 0);
  json_node position = json_element(node, 1);
  t_s = json_number(&time, 0, 1e9, 0);
  position_read(&position, &x_m, &y_m);
  add_point(&board->path_x, node, (series_point){t_s, x_m});
  add_point(&board->path_y, node, (series_point){t_s, y_m});
}

// A position, or a path that begins with one.
static void read_place(board_config *board, const json_node *node) {
  json_node position = json_member(node, "position");
  json_node path = json_member(node, "path");
  size_t count = json_array_length(&path);
  position_read(&position, &board->x_m, &board->y_m);
  if (!json_given(&path)) return;
  if (count == 0) json_expected(&path, "a list of points [[seconds, [x, y]], …]");
  if (json_given(&position)) json_fail(&position, "the path says where the board is; expected one of the two");
  if (board->vehicle.radius_m > 0)
    json_fail(&path, "the board's vehicle drives where it will; expected one of the two");
  board->path_x.points = calloc(count + 1, sizeof *board->path_x.points);
  board->path_y.points = calloc(count + 1, sizeof *board->path_y.points);
  for (size_t i = 0; i < count && !json_failed(path.reader); i++) {
    json_node point = json_element(&path, i);
    read_path_point(board, &point);
  }
  if (board->path_x.count == 0) return;
  board->x_m = board->path_x.points[0].value;
  board->y_m = board->path_y.points[0].value;
}

static void read_clock_error(board_config *board, const json_node *node) {
  json_int_t ppm = json_integer_value(node->value);
  if (!json_given(node)) return;
  if (!json_is_integer(node->value) || ppm < -MAX_CLOCK_ERROR_PPM || ppm > MAX_CLOCK_ERROR_PPM)
    json_expected(node, "a whole number from -50000 to 50000");
  board->clock_error_ppm = (int)ppm;
}

static char *required_text(const json_node *board, const char *key) {
  json_node node = json_member(board, key);
  char *text = json_text(&node);
  if (!text) json_expected(&node, "a text in quotes");
  return text;
}

static char *optional_text(const json_node *board, const char *key) {
  json_node node = json_member(board, key);
  return json_text(&node);
}

static void read_bridge(board_config *board, const json_node *node) {
  static const char *const KEYS[] = {"latency", NULL};
  if (!json_given(node) || !json_check_object(node, KEYS)) return;
  json_node latency = json_member(node, "latency");
  board->bridge_latency_ms = json_number(&latency, 0, MAX_BRIDGE_LATENCY_MS, 0);
}

static void read_wiring(board_config *board, const json_node *node) {
  json_node reset_on_open = json_member(node, "resetOnOpen");
  json_node bridge = json_member(node, "bridge");
  json_node tx = json_member(node, "txPin");
  json_node rx = json_member(node, "rxPin");
  json_node aux = json_member(node, "auxPin");
  json_node clock_error = json_member(node, "clockError");
  board->reset_on_open = json_flag(&reset_on_open, true);
  read_bridge(board, &bridge);
  board->tx_pin = pin_read(&tx, board->model, DEFAULT_TX_PIN);
  board->rx_pin = pin_read(&rx, board->model, DEFAULT_RX_PIN);
  if (board->rx_pin == board->tx_pin) json_expected(&rx, "another pin than txPin");
  board->aux_pin = json_given(&aux) ? pin_read(&aux, board->model, -1) : -1;
  read_clock_error(board, &clock_error);
}

// No board may have the injector's name: the trace calls the injector so.
static void check_name(const char *name, const json_node *board) {
  json_node node = json_member(board, "name");
  if (name && strcmp(name, INJECTOR) == 0) json_expected(&node, "another name: the injector of the trace has this one");
}

void board_config_read(board_config *board, const json_node *node, const char *scenario_directory,
                       const char *directory) {
  static const char *const KEYS[] = {"name",     "model",  "firmware",    "bootLoader", "port",       "eeprom",
                                     "position", "path",   "resetOnOpen", "bridge",     "clockError", "txPin",
                                     "rxPin",    "auxPin", "sensors",     "watch",      "vehicle",    NULL};
  if (!json_check_object(node, KEYS)) return;
  json_node chosen = json_member(node, "model");
  int index = json_choice(&chosen, MODEL_NAMES);
  board->model = model_at(index < 0 ? 0 : index);
  board->name = required_text(node, "name");
  check_name(board->name, node);
  board->firmware = join_path(scenario_directory, required_text(node, "firmware"));
  board->boot_loader = join_path(scenario_directory, optional_text(node, "bootLoader"));
  board->port = join_path(directory, optional_text(node, "port"));
  board->eeprom = join_path(directory, optional_text(node, "eeprom"));
  read_wiring(board, node);
  json_node sensors = json_member(node, "sensors");
  json_node watches = json_member(node, "watch");
  json_node vehicle = json_member(node, "vehicle");
  read_vehicle(&board->vehicle, &vehicle, board->model);
  read_place(board, node);
  read_sensors(board, &sensors);
  check_sonars(board, &sensors);
  read_watches(board, &watches);
}

void board_config_release(board_config *board) {
  free(board->name);
  free(board->firmware);
  free(board->boot_loader);
  free(board->port);
  free(board->eeprom);
  free(board->path_x.points);
  free(board->path_y.points);
  for (size_t i = 0; i < board->sensor_count; i++) free(board->sensors[i].values.points);
  for (size_t i = 0; i < board->watch_count; i++) free(board->watches[i].name);
  free(board->sensors);
  free(board->watches);
}
