// SPDX-License-Identifier: GPL-3.0-or-later
// A pseudo-terminal whose path is stable: a symlink that the scenario names. Bytes from the board pass a USB bridge.
#ifndef JAVINO_PTY_H
#define JAVINO_PTY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "bridge.h"
#include "clock.h"

#define PTY_BUFFER 4096

typedef enum { PTY_SAME, PTY_OPENED, PTY_CLOSED } pty_change;

typedef struct {
  const char *link;        // the symlink's path
  char slave[64];          // what it points to
  int master;              // -1: unplugged
  bool open;               // a host has the slave open
  bool held;               // time stands still, and the host's writes wait
  uint8_t in[PTY_BUFFER];  // from the host, not yet taken
  size_t in_start, in_end;
  uint8_t out[PTY_BUFFER];  // for the host, not yet written
  size_t out_length;
  cycles_t put_at;          // when the last of them came
  bridge usb;               // holds the last bytes of `out` back
  size_t got, gave;         // bytes of the last exchange; of a played port, of the next one
  bool played;              // no host: pty_play says what comes, and nothing is made in the file system
  pty_change coming;        // of a played port, with the next exchange
  uint64_t received, sent;  // bytes
  uint64_t dropped;         // bytes from the board that no host read
} pty;

// Makes a pty in raw mode and then the symlink, with its folders, in place of an older symlink.
// Returns 0, or -1 with one line in `error`; anything at `link` that is no symlink is left alone.
int pty_plug(pty *p, const char *link, char *error, size_t error_size);

// Takes pty and symlink away; a host that has it open gets an end of file. Counters stay.
void pty_unplug(pty *p);

// Moves bytes both ways without waiting, and tells whether a host has opened or closed the pty.
// A close and an open between two calls are not seen.
pty_change pty_exchange(pty *p, cycles_t now);

// While time stands still the line does too: by flow control (XOFF) the host's writes wait, as for a device that is not
// ready, instead of its patience with replies that cannot come.
void pty_hold(pty *p, bool held);

// How many bytes from the host the buffer takes now.
size_t pty_room(pty *p);

// Says what the next exchange of a played port brings: `length` bytes come, `gave` go. Returns 0, or -1 where a host could
// not have done so.
int pty_play(pty *p, pty_change change, const uint8_t *bytes, size_t length, size_t gave);

// The next byte from the host; false when there is none.
bool pty_take(pty *p, uint8_t *byte);

// A byte for the host; dropped and counted when the host is gone or does not read.
void pty_put(pty *p, uint8_t byte, cycles_t now);

// The descriptor to wait on for input, or -1 when there is nothing that could be taken.
int pty_poll_descriptor(const pty *p);

#endif
