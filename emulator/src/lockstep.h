// SPDX-License-Identifier: GPL-3.0-or-later
// Lock-step: hosts say line by line how far time goes on and what they do, and are told what the boards have for them.
// emulator/README.md documents the lines.
#ifndef JAVINO_LOCKSTEP_H
#define JAVINO_LOCKSTEP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "emulation.h"

// The longest line without its end: a write of as many bytes as a port takes.
#define LOCKSTEP_MAX_LINE (2 * PTY_BUFFER + 16)
// A board's bytes are handed over when so many are there, or when none has followed for so long.
#define LOCKSTEP_MANY 256
#define LOCKSTEP_QUIET CYCLES_PER_MS
// Emulated time between two calls of `pass`.
#define LOCKSTEP_PASS CYCLES_PER_MS

typedef struct {
  void *context;
  // Performs a command of the control socket. Returns 0, or -1 with one line in `error`.
  int (*perform)(void *context, const char *line, size_t length, char *error, size_t error_size);
  // Does what is due beside the run. Returns whether the run goes on.
  bool (*pass)(void *context);
} lockstep_listener;

// A port as its host was told.
typedef struct {
  bool there, open;
} lockstep_port;

typedef struct {
  emulation *e;
  cycles_t end;  // of the run
  lockstep_listener listener;
  FILE *answers;
  lockstep_port ports[MAX_BOARDS];
  cycles_t next_pass;
  char line[LOCKSTEP_MAX_LINE + 1];
  size_t length;         // of what is there of the line
  unsigned long number;  // of the line, from 1
  char error[512];       // why a call returned LOCKSTEP_REFUSED or LOCKSTEP_FAILED
} lockstep;

typedef enum {
  LOCKSTEP_ON,
  LOCKSTEP_ENDED,    // the run is at its end, or was broken off
  LOCKSTEP_REFUSED,  // a line was wrong
  LOCKSTEP_FAILED    // the run, or the answers could not be written
} lockstep_state;

// For an emulation whose ports are played. It must outlive the lock-step.
void lockstep_init(lockstep *l, emulation *e, cycles_t end, lockstep_listener listener, FILE *answers);

// Performs the lines that are whole with these bytes, and answers each.
lockstep_state lockstep_take(lockstep *l, const char *bytes, size_t length);

// No bytes follow. Returns LOCKSTEP_ENDED, or LOCKSTEP_REFUSED where a line lacks its end.
lockstep_state lockstep_finish(lockstep *l);

#endif
