// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody without a board who puts packets on the air, one after the other: what commands have it send.
#ifndef JAVINO_STRANGER_H
#define JAVINO_STRANGER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clock.h"
#include "line_code.h"

#define STRANGER_QUEUE 16

typedef struct {
  double x_m, y_m;  // where it stands meanwhile
  uint8_t payload[LINE_MAX_PAYLOAD];
  size_t length;  // at least 1
  unsigned hops;  // less than LINE_HOPS
} stranger_packet;

typedef struct {
  void *context;
  // A packet begins, from its place.
  void (*begins)(void *context, const stranger_packet *packet, cycles_t at);
  void (*carrier)(void *context, bool carrier, cycles_t at);
} stranger_listener;

typedef struct {
  stranger_listener listener;
  cycles_t bit_cycles;
  stranger_packet queue[STRANGER_QUEUE];  // the first one is on the air, or comes next
  size_t count;
  uint8_t bits[LINE_MAX_BITS];
  size_t bit_count, sent;  // of the packet on the air; both 0 between two packets
  cycles_t next;           // when the next bit begins; NEVER while there is nothing to send
} stranger;

void stranger_init(stranger *s, double bit_rate, stranger_listener listener);

// Sends the packet when those before it are out. Returns 0, or -1 where STRANGER_QUEUE of them wait.
int stranger_send(stranger *s, const stranger_packet *packet, cycles_t now);

// Sends what comes before `until`.
void stranger_advance(stranger *s, cycles_t until);

#endif
