// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody without a board who puts packets on the air, one after the other: what commands have it send.
#ifndef JAVINO_INJECTOR_H
#define JAVINO_INJECTOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clock.h"
#include "line_code.h"

#define INJECTOR_QUEUE 16

typedef struct {
  double x_m, y_m;  // where it stands meanwhile
  uint8_t payload[LINE_MAX_PAYLOAD];
  size_t length;  // at least 1
  unsigned path;  // less than LINE_PATHS
} injector_packet;

typedef struct {
  void *context;
  // A packet begins, from its place.
  void (*begins)(void *context, const injector_packet *packet, cycles_t at);
  void (*carrier)(void *context, bool carrier, cycles_t at);
} injector_listener;

typedef struct {
  injector_listener listener;
  cycles_t bit_cycles;
  injector_packet queue[INJECTOR_QUEUE];  // the first one is on the air, or comes next
  size_t count;
  uint8_t bits[LINE_MAX_BITS];
  size_t bit_count, sent;  // of the packet on the air; both 0 between two packets
  cycles_t next;           // when the next bit begins; NEVER while there is nothing to send
} injector;

void injector_init(injector *s, double bit_rate, injector_listener listener);

// Sends the packet when those before it are out. Returns 0, or -1 where INJECTOR_QUEUE of them wait.
int injector_send(injector *s, const injector_packet *packet, cycles_t now);

// Sends what comes before `until`.
void injector_advance(injector *s, cycles_t until);

#endif
