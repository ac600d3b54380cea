// SPDX-License-Identifier: GPL-3.0-or-later
// All boards of a scenario, the air between them and what is plugged into them.
#ifndef JAVINO_EMULATION_H
#define JAVINO_EMULATION_H

#include <poll.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "board.h"
#include "eeprom_file.h"
#include "fault_plan.h"
#include "point_log.h"
#include "prng.h"
#include "pty.h"
#include "record.h"
#include "rf_bus.h"
#include "scenario.h"
#include "sensor.h"
#include "serial_module.h"
#include "serial_sniffer.h"
#include "sniffer.h"
#include "injector.h"
#include "trace.h"
#include "uart.h"
#include "world.h"

// How often EEPROM files are brought up to date.
#define EEPROM_INTERVAL (50 * CYCLES_PER_MS)

// A board and what hangs on it.
typedef struct {
  struct emulation *owner;
  size_t index;
  const board_config *config;
  board arduino;
  pty port;
  uart serial;
  serial_sniffer line;
  point_log declared;
  eeprom_file eeprom;
  sensor *sensors;
  prng noise;               // what RAM and torn EEPROM bytes hold after a power cut
  const fault_config *cut;  // the power cut that comes with this EEPROM write
  cycles_t power_at;        // when the power comes back, NEVER while it is there
  bool plugged;             // the port is there whenever the power is
  uint64_t resets, power_cuts;
  const char *reset_why;  // of the reset under way, where the emulation itself asks for it
} node;

typedef struct emulation {
  const scenario *config;
  trace *out;
  rf_bus air;
  sniffer listener;
  serial_modules modules;
  node *nodes;
  size_t node_count;
  fault_plan faults;
  size_t next_jam;
  world surroundings;
  injector injector;
  record *kept;        // what comes from outside; NULL: it is not kept
  double speed_asked;  // by a command, below 0 where none has asked; the caller keeps the time
  cycles_t now;
  cycles_t next_eeprom_save;
  char error[512];  // why a call returned -1
} emulation;

// Powers all boards on. `config` and `out` must outlive the emulation; close it either way.
// Returns 0, or -1 with one line in `error`.
int emulation_open(emulation *e, const scenario *config, uint64_t seed, trace *out);

// The same with played ports, so that no ptys are made. With `eeproms` no EEPROM file is touched: boards begin with these,
// each as large as the model's or NULL.
int emulation_open_played(emulation *e, const scenario *config, uint64_t seed, trace *out, uint8_t *const *eeproms);

// Keeps what comes from outside from now on, and writes down keys that hosts give boards; either may be NULL.
void emulation_keep(emulation *e, record *kept, FILE *keys);

// Runs all boards up to `until`. Returns 0, or -1 with one line in `error`: a program crashed, or
// a port or file could not be written.
int emulation_run(emulation *e, cycles_t until);

// When something happens next: up to there nothing but time goes on. Not after `now` where a board is busy.
cycles_t emulation_next_event(const emulation *e);

// A fault comes now. A jam of the scenario is on the air by itself. Returns 0, or -1 with one line in `error`.
int emulation_fault(emulation *e, const fault_config *fault);

// Moves bytes between boards and hosts, and sees who opened or closed a port. Call it every
// millisecond or so.
void emulation_exchange(emulation *e);

// Has the hosts wait while time stands still.
void emulation_hold(emulation *e, bool held);

// Fills in what to wait on for input from hosts; `descriptors` has room for one a board.
// Returns how many there are.
size_t emulation_descriptors(const emulation *e, struct pollfd *descriptors);

// Whether a byte has passed a port within the last 2 ms.
bool emulation_serial_busy(const emulation *e);

// Writes the counters, saves the EEPROM files and takes the ports away.
// Returns 0, or -1 with one line in `error`.
int emulation_close(emulation *e);

#endif
