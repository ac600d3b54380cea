// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a recorded run again.
#ifndef JAVINO_REPLAY_H
#define JAVINO_REPLAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "emulation.h"

typedef struct {
  const char *path;
  FILE *file;
  char *text;  // of the line
  size_t capacity;
  unsigned line;
  bool exchange_due;             // the boards have run, and not yet exchanged with their hosts
  uint64_t seed;                 // of the recorded run
  uint8_t *eeproms[MAX_BOARDS];  // what they held; NULL: nothing
} replay;

// Opens the file, and sets the radio as it was. Returns 0, or -1 with one line in `error`: unreadable, no record, or one of
// other boards; close it either way.
int replay_open(replay *r, const char *path, scenario *s, char *error, size_t error_size);
void replay_close(replay *r);

// Plays the next line. Returns 1, 0 at the end, or -1 with one line in `error`.
int replay_step(replay *r, emulation *e, char *error, size_t error_size);

#endif
