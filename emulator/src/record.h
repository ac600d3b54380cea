// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps all that comes into a run from outside, with its exact cycle, so that the same run can be made again: what EEPROMs
// hold at the start, what hosts do and send, and commands. emulator/README.md documents the lines. The file holds the keys
// that a host sends to its board: it is for its user only.
#ifndef JAVINO_RECORD_H
#define JAVINO_RECORD_H

#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "clock.h"
#include "pty.h"

struct emulation;

#define RECORD_VERSION 1

typedef struct {
  FILE *file;        // NULL: nothing is kept
  bool in_exchange;  // its line has begun
} record;

// Makes the file; without a path keeps nothing. Returns 0, or -1 with the problem in private_problem().
int record_open(record *r, const char *path);

// Closes the file. Returns 0, or -1 where something could not be written.
int record_close(record *r);

bool record_failed(const record *r);

// The beginning of the run.
void record_start(record *r, const struct emulation *e, uint64_t seed);

// The boards run up to `until`, and then exchange with the hosts.
void record_run(record *r, cycles_t until);

// The bytes of a port's exchange, if there are any; to be called before they are taken.
void record_port(record *r, const char *board, const pty *port, pty_change change);

// All ports have exchanged.
void record_exchange_end(record *r);

void record_command(record *r, const json_t *given);

#endif
