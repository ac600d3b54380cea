// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge.h"

void bridge_start(bridge *b, cycles_t now) {
  b->held = 0;
  b->timer_end = now + b->latency;
}

void bridge_put(bridge *b, cycles_t now) {
  if (b->latency == 0) return;
  if (bridge_held(b, now) + 1 == BRIDGE_PACKET)
    bridge_start(b, now);
  else
    b->held++;
}

size_t bridge_held(bridge *b, cycles_t now) {
  if (b->latency == 0 || now < b->timer_end) return b->held;
  cycles_t late = (now - b->timer_end) % b->latency;
  bridge_start(b, now - late);
  return 0;
}
