// SPDX-License-Identifier: GPL-3.0-or-later
#include "stranger.h"

#include <string.h>

// The silence between two packets, with some bits to spare.
#define PAUSE_BITS (LINE_IDLE_BITS + 8)

void stranger_init(stranger *s, double bit_rate, stranger_listener listener) {
  memset(s, 0, sizeof *s);
  s->listener = listener;
  s->bit_cycles = (cycles_t)(CYCLES_PER_SECOND / bit_rate + 0.5);
  s->next = NEVER;
}

int stranger_send(stranger *s, const stranger_packet *packet, cycles_t now) {
  if (s->count == STRANGER_QUEUE) return -1;
  s->queue[s->count++] = *packet;
  if (s->next == NEVER) s->next = now;
  return 0;
}

static void begin(stranger *s) {
  s->bit_count = line_encode(s->bits, s->queue[0].payload, s->queue[0].length, s->queue[0].hops);
  s->sent = 0;
  s->listener.begins(s->listener.context, &s->queue[0], s->next);
}

static void end(stranger *s) {
  s->listener.carrier(s->listener.context, false, s->next);
  s->bit_count = s->sent = 0;
  s->count--;
  memmove(s->queue, s->queue + 1, s->count * sizeof *s->queue);
  s->next += PAUSE_BITS * s->bit_cycles;
}

void stranger_advance(stranger *s, cycles_t until) {
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
