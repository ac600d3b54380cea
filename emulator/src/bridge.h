// SPDX-License-Identifier: GPL-3.0-or-later
// The USB bridge between a board's UART and the host, as far as it holds bytes from the board back. It works as an FTDI chip
// does (application note AN232B-04): bytes wait in a USB packet, which goes when it is full or when the latency timer ends.
// The timer runs all the time and starts anew with each packet, so a byte waits for at most the latency. An empty packet goes
// too, since it carries the chip's status.
#ifndef JAVINO_BRIDGE_H
#define JAVINO_BRIDGE_H

#include <stddef.h>

#include "clock.h"

// Bytes of the board in a full packet: the chip fills 2 of its 64 with its status.
#define BRIDGE_PACKET 62

// All zero: a bridge that passes each byte on at once.
typedef struct {
  cycles_t latency;    // of the timer; 0: each byte is passed on at once
  cycles_t timer_end;  // when the timer sends the packet
  size_t held;         // bytes in the packet
} bridge;

// The packet is empty, and the timer starts: a host has opened the port, or a packet has gone.
void bridge_start(bridge *b, cycles_t now);

// A byte comes from the board.
void bridge_put(bridge *b, cycles_t now);

// Lets the timer run up to `now`. Returns how many bytes are held back then: the last ones that were put.
size_t bridge_held(bridge *b, cycles_t now);

#endif
