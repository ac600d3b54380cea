// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario to emulate: its file, read and checked. emulator/README.md documents every key.
#ifndef JAVINO_SCENARIO_H
#define JAVINO_SCENARIO_H

#include <stdbool.h>
#include <stddef.h>

#include "model.h"
#include "series.h"

#define MAX_BOARDS 48
#define MIN_BIT_RATE 100
#define MAX_BIT_RATE 10000
// The name of the sender that is no board.
#define INJECTOR "injector"
#define MAX_OBSTACLES 64
#define MAX_DISTANCE_RATES 16

// Errors in bursts (Gilbert-Elliott).
typedef struct {
  double rate;         // of all bits, below rate_within; 0: no bursts
  double length_bits;  // on average, 1 or more
  double rate_within;  // of the bits of a burst, 0…1
} burst_config;

typedef struct {
  double metres;
  double rate;  // 0…1
} distance_rate;

// The noise that a receiver gives while it hears nobody.
typedef struct {
  double edges_per_s;  // on average; 0: no noise
  double after_s;      // so long after the last carrier
} noise_config;

#define MODULE_MAX_BUFFER 1024
#define MODULE_MAX_PIECE 240

// A module that carries bytes from UART to UART.
typedef struct {
  const char *name;  // NULL: boards have a transmitter and a receiver for on-off keying
  double uart_rate;  // bit/s, of which a byte takes 10
  double air_rate;   // bit/s, of which a byte takes 8
  double lead_s;     // of a piece on the air before its bytes
  double pause_s;    // on the UART, after which what has come is sent
  double delay_s;    // from there to the air
  size_t piece;      // bytes that are sent at once
  size_t buffer;     // bytes each way, beyond which they are lost
} module_config;

typedef struct {
  double bit_rate;        // bit/s, 100…10000; of modules their air rate
  double range_m;         // metres, 0 or more
  double bit_error_rate;  // probability 0…1 for each bit slot and receiver
  burst_config bursts;
  distance_rate distance_rates[MAX_DISTANCE_RATES];  // in rising order of metres
  size_t distance_rate_count;                        // 0: no errors by distance
  double shadowing_db;                               // standard deviation, 0: none
  noise_config noise;
  double capture_db;  // 0: no signal is heard over another one
  module_config module;
  double loss;  // probability 0…1 for each piece of a module and receiver
} radio_config;

typedef enum { SENSOR_HC_SR04, SENSOR_LDR, SENSOR_DIGITAL } sensor_kind;

typedef struct {
  sensor_kind kind;
  int pin;        // LDR: analog pin; digital: pin; HC-SR04: echo
  int trigger;    // HC-SR04 only
  double noise;   // standard deviation of its measurements, in their unit
  series values;  // HC-SR04: cm; LDR: 0…1023 as analogRead() gives; digital: 0 or 1; empty: what the world has
  int after_pin;  // the series' clock starts when this pin first has after_level; -1: at once
  int after_level;
} sensor_config;

typedef struct {
  int pin;
  char *name;
} watch_config;

// Two motors, left and right, each driven by two pins.
typedef struct {
  double heading_deg;  // 0: along x, counterclockwise
  double speed_m_s;    // while both motors turn forward
  double radius_m;     // 0: the board is on no vehicle
  int forward[2], backward[2];
} vehicle_config;

typedef struct {
  char *name;
  double x_m, y_m, radius_m;
} obstacle_config;

typedef struct {
  double light;  // 0…1023
  obstacle_config *obstacles;
  size_t obstacle_count;
} world_config;

typedef struct {
  char *name;
  const model *model;
  char *firmware;         // path of an ELF file, as the process sees it
  char *boot_loader;      // path of a HEX file; NULL: none
  char *port;             // path of the pty's symlink, NULL: UART lines go to the trace
  char *eeprom;           // path of the EEPROM file, NULL: forgotten at exit
  double x_m, y_m;        // at the start
  series path_x, path_y;  // where it is at what time, in metres; empty: it stays there
  vehicle_config vehicle;
  bool reset_on_open;
  double bridge_latency_ms;  // 0…255, 0: bytes are not held back
  int clock_error_ppm;       // how much faster its clock runs
  int tx_pin, rx_pin;
  int aux_pin;  // of a module, -1: not joined
  sensor_config *sensors;
  size_t sensor_count;
  watch_config *watches;
  size_t watch_count;
} board_config;

typedef enum { FAULT_RESET, FAULT_UNPLUG, FAULT_PLUG, FAULT_POWER_CUT, FAULT_JAM } fault_kind;

typedef struct {
  double t_s;
  fault_kind kind;
  size_t board;   // index; not for jam
  int after_pin;  // t counts from when this pin of the board first has after_level; -1: from the start
  int after_level;
  double duration_s;       // power cut and jam only
  unsigned eeprom_writes;  // power cut only: comes with this write after t, 0: at t
  bool has_position;       // jam only; without one it is heard everywhere
  double x_m, y_m;
} fault_config;

typedef struct {
  radio_config radio;
  board_config *boards;
  size_t board_count;
  fault_config *faults;  // in rising order of t
  size_t fault_count;
  world_config world;
} scenario;

// The additions of the command line to the file.
typedef struct {
  const char *directory;   // ports and EEPROM files are relative to it
  const char **overrides;  // "radio.key=value"
  size_t override_count;
} scenario_context;

// Reads `path` into `result`. Returns 0, or -1 with one line in `error`; release it either way.
int scenario_load(scenario *result, const char *path, const scenario_context *context, char *error, size_t error_size);

void scenario_release(scenario *result);

#endif
