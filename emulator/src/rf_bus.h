// SPDX-License-Identifier: GPL-3.0-or-later
// The air: joins the TX pins of all boards to their RX pins by on-off keying.
//
// A receiver's level is the OR of the carriers that it hears, so collisions come by themselves. The one that comes from so
// much nearer than all others may be heard alone, if the radio captures. Bits of the result may be wrong.
// Every level arrives RF_DELAY after it was sent, whatever the order in which boards are run:
// that keeps edges exact to the cycle although boards take turns of RF_STEP.
#ifndef JAVINO_RF_BUS_H
#define JAVINO_RF_BUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clock.h"
#include "prng.h"
#include "scenario.h"

#define RF_STEP (100 * CYCLES_PER_US)
// A board may overrun its turn by less than the difference.
#define RF_DELAY (110 * CYCLES_PER_US)
// A transmission is over after so many bits without carrier; no symbols hold such a gap.
#define RF_QUIET_BITS 8
// Boards, the injector and jammers.
#define MAX_SOURCES 64

typedef struct {
  void *context;
  // The level at a receiver's RX pin changes at `at`.
  void (*level)(void *context, size_t receiver, bool level, cycles_t at);
  // A transmission begins to overlap others at a receiver; bit n of `sources` is source n.
  void (*collision)(void *context, size_t receiver, uint64_t sources, cycles_t at);
} rf_listener;

typedef struct {
  size_t source;
  bool carrier;
  cycles_t at;
} rf_edge;

// A board's transmitter, the injector's, or a jammer.
typedef struct {
  bool everywhere;  // heard at any distance
  double x_m, y_m;
  bool carrier;
  bool active;        // in the middle of a transmission
  cycles_t quiet_at;  // when the transmission is over unless the carrier comes back
  cycles_t jam_end;
  cycles_t next_toggle;
  prng noise;
} rf_source;

// A jam fault of the scenario. Jams that do not overlap share a jammer.
typedef struct {
  size_t source;
  const fault_config *fault;
} rf_jam;

typedef struct {
  uint64_t hears;  // bit n: source n is in range
  bool level;
  bool hearing;        // a transmission
  bool flip;           // the current bit slot is an error; while nothing is heard, noise is high
  cycles_t next_slot;  // when that may change
  prng errors, noise;
  bool in_burst;
  cycles_t burst_change;
  prng bursts;
  double metres[MAX_SOURCES];  // from how far each is heard, as propagation.h tells it
} rf_receiver;

typedef struct {
  rf_listener listener;
  cycles_t bit_cycles;
  radio_config radio;
  bool has_errors;       // of any kind
  double capture_ratio;  // 0: no capture
  uint64_t seed;
  size_t board_count;
  size_t planned_count;  // sources but for the jammers of commands
  size_t source_count;   // boards first, then the injector, then jammers
  rf_source *sources;
  rf_receiver *receivers;
  rf_jam *jams;
  rf_edge *edges;  // not yet on the air, in rising order of time
  size_t edge_count, edge_capacity;
  cycles_t next_event;  // no source or receiver has anything to do before
} rf_bus;

// Sets up boards and jam faults of the scenario: source n is board n, then come the injector and the jammers.
// Returns 0, or -1 where the memory does not suffice or boards and jams at one time are more than 63.
int rf_bus_init(rf_bus *bus, const scenario *config, uint64_t seed, rf_listener listener);
void rf_bus_release(rf_bus *bus);

// Board `source` switches its carrier at `at`, not before the last rf_bus_advance.
void rf_bus_carrier(rf_bus *bus, size_t source, bool carrier, cycles_t at);

// Jam number `jam` of the scenario sends random bits until `end`.
void rf_bus_jam(rf_bus *bus, size_t jam, cycles_t at, cycles_t end);

// Sends random bits as a fault that the scenario does not have. Returns 0, or -1 where 64 sources are there already.
int rf_bus_jam_now(rf_bus *bus, const fault_config *jam, cycles_t at, cycles_t end);

// A source, and where it is a board's the receiver with it, is elsewhere from now on.
void rf_bus_move(rf_bus *bus, size_t source, double x_m, double y_m, cycles_t now);

// The radio is another one from now on, all but its bit rate.
void rf_bus_set_radio(rf_bus *bus, const radio_config *radio, cycles_t now);

// Plays all that happens on the air before `until`.
void rf_bus_advance(rf_bus *bus, cycles_t until);

// Whether `receiver` is in range of `source`.
bool rf_bus_hears(const rf_bus *bus, size_t receiver, size_t source);

#endif
