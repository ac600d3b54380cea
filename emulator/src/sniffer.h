// SPDX-License-Identifier: GPL-3.0-or-later
// Listens to each board's TX pin and to what reaches each board's RX pin, and writes down what a
// bystander without keys can tell: rf-tx, rf-rx, rf-damaged and rf-collision events.
#ifndef JAVINO_SNIFFER_H
#define JAVINO_SNIFFER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clock.h"
#include "line_code.h"
#include "rf_bus.h"
#include "scenario.h"
#include "trace.h"

#define SNIFFER_MAX_EXPECTED 8

// A packet that was sent in a receiver's range and has not arrived yet.
typedef struct {
  size_t source;
  uint64_t number;
  cycles_t start, end;
  cycles_t deadline;
  uint8_t payload[LINE_MAX_PAYLOAD];
  size_t length;
  unsigned path;
} sniffer_expected;

typedef struct {
  uint64_t sent;          // packets that left the TX pin whole, whatever became of a trailer
  uint64_t undecodable;   // started on the TX pin, but not by the line code
  uint64_t received;      // packets that reached the RX pin whole
  uint64_t damaged;       // packets that were in range and did not
  uint64_t collisions;    // overlaps at the RX pin
  uint64_t not_followed;  // packets in range beyond what can be followed at once
} sniffer_counters;

typedef struct {
  struct sniffer *owner;
  size_t board;
  line_decoder tx, rx;
  uint64_t sending;  // the number of its packet on the air, or of the last one
  uint64_t heard;    // of the last packet that has come to it, damaged or not; 0: none yet
  sniffer_expected expected[SNIFFER_MAX_EXPECTED];
  size_t expected_count;
  line_error last_error;  // of the RX pin
  cycles_t last_error_at;
  sniffer_counters counters;
  double *airtime_s;  // of the packets sent in each hour of the run, in seconds
  size_t hours;
} sniffer_station;

typedef struct sniffer {
  const scenario *config;
  const rf_bus *bus;
  trace *out;
  sniffer_station *stations;  // of the boards, then the injector's, who only sends
  bool ending;                // what is on the air is broken off
  uint64_t packets;           // that have a number: from 1 on, in the order in which they were whole
  cycles_t next_deadline;
  double bit_cycles;
} sniffer;

// Returns 0, or -1 where the memory does not suffice.
int sniffer_init(sniffer *s, const scenario *config, const rf_bus *bus, trace *out);
// Tells what is on the air when the run ends, as far as it was sent.
void sniffer_end(sniffer *s);
void sniffer_release(sniffer *s);

// `board` may be the injector: the number of boards.
void sniffer_tx_edge(sniffer *s, size_t board, bool level, cycles_t at);
void sniffer_rx_edge(sniffer *s, size_t board, bool level, cycles_t at);
void sniffer_collision(sniffer *s, size_t receiver, uint64_t sources, cycles_t at);

// A packet of serial modules has left that of `source`, and has come to those in range but `missed`. Without a length its bytes
// are no packet.
void sniffer_module_packet(sniffer *s, size_t source, const line_packet *packet, uint64_t missed);

// Nothing else happens on any TX pin, or any RX pin, before `now`.
void sniffer_advance_tx(sniffer *s, cycles_t now);
void sniffer_advance_rx(sniffer *s, cycles_t now);

#endif
