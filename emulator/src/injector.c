// SPDX-License-Identifier: GPL-3.0-or-later
#include "injector.h"

#include <string.h>

// The silence between two packets, with some bits to spare.
#define PAUSE_BITS (LINE_IDLE_BITS + 8)

void injector_init(injector *s, double bit_rate, injector_listener listener) {
  memset(s, 0, sizeof *s);
  s->listener = listener;
  s->bit_cycles = (cycles_t)(CYCLES_PER_SECOND / bit_rate + 0.5);
  s->next = NEVER;
}

int injector_send(injector *s, const injector_packet *packet, cycles_t now) {
  if (s->count == INJECTOR_QUEUE) return -1;
  s->queue[s->count++] = *packet;
  if (s->next == NEVER) s->next = now;
  return 0;
}

static void begin(injector *s) {
  s->bit_count = line_encode(s->bits, s->queue[0].payload, s->queue[0].length, s->queue[0].path);
  s->sent = 0;
  s->listener.begins(s->listener.context, &s->queue[0], s->next);
}

static void end(injector *s) {
  s->listener.carrier(s->listener.context, false, s->next);
  s->bit_count = s->sent = 0;
  s->count--;
  memmove(s->queue, s->queue + 1, s->count * sizeof *s->queue);
  s->next += PAUSE_BITS * s->bit_cycles;
}

void injector_advance(injector *s, cycles_t until) {
  while (s->next < until) {
    if (s->bit_count > 0 && s->sent == s->bit_count) {
      end(s);
    } else if (s->bit_count == 0 && s->count == 0) {
      s->next = NEVER;  // the pause after the last packet is over
    } else {
      if (s->bit_count == 0) begin(s);
      s->listener.carrier(s->listener.context, s->bits[s->sent++], s->next);
      s->next += s->bit_cycles;
    }
  }
}
