// SPDX-License-Identifier: GPL-3.0-or-later
// The command line.
#ifndef JAVINO_OPTIONS_H
#define JAVINO_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MAX_OVERRIDES 16

typedef struct {
  const char *scenario;
  const char *directory;                  // "." by default
  const char *trace_path;                 // NULL: none; "-": standard output
  const char *record_path, *replay_path;  // NULL: none
  const char *paced_option;               // one that lock-step has no use for; NULL: none
  const char *run_option;                 // one that a recorded run has already; NULL: none
  const char *keys_path;                  // NULL: none
  const char *control_path;               // of a socket; NULL: none
  double duration_s;                      // 0: without end
  double speed;                           // 0: as fast as possible
  uint64_t seed;
  const char *overrides[MAX_OVERRIDES];
  size_t override_count;
  bool lockstep;
  bool help;
} options;

extern const char OPTIONS_USAGE[];

// Returns 0, or -1 with one line in `error`.
int options_parse(options *o, int argc, char **argv, char *error, size_t error_size);

#endif
