// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "suggest.h"

const char OPTIONS_USAGE[] =
    "usage: javino-emulator SCENARIO.json [options]\n"
    "  --duration S         end after S emulated seconds (default: run until interrupted)\n"
    "  --speed X|max        emulated seconds a second (default 1), or as fast as possible\n"
    "  --seed N             start of all random numbers (default 1)\n"
    "  --trace FILE|-       write the trace there, - for standard output\n"
    "  --directory DIR      ports and EEPROM files are relative to it (default: here)\n"
    "  --control PATH       take commands from a Unix domain socket there\n"
    "  --keys FILE          add each key that a host gives a board, as to a keyring\n"
    "  --record FILE        keep what comes from outside, so that the run can be made again; it holds keys\n"
    "  --replay FILE        make a recorded run again, without hosts\n"
    "  --lockstep           take time and what hosts do from standard input\n"
    "  --set radio.key=N    override a radio number of the scenario; may be repeated\n";

static const char *const NAMES[] = {"--duration", "--speed",   "--seed", "--trace",  "--directory",
                                    "--set",      "--control", "--keys", "--record", "--replay",
                                    "--lockstep", "--help",    NULL};

typedef struct {
  char *error;
  size_t size;
} complaint;

static int complain(const complaint *c, const char *option, const char *expected, const char *found) {
  snprintf(c->error, c->size, "%s: expected %s, found \"%.60s\"", option, expected, found);
  return -1;
}

static int parse_positive(double *number, const char *option, const char *text, const complaint *c) {
  char *end;
  *number = strtod(text, &end);
  if (end == text || *end || !isfinite(*number) || *number <= 0) return complain(c, option, "a number above 0", text);
  return 0;
}

static int parse_speed(double *speed, const char *text, const complaint *c) {
  *speed = 0;
  if (strcmp(text, "max") == 0) return 0;
  if (parse_positive(speed, "--speed", text, c) != 0) return complain(c, "--speed", "a number above 0, or max", text);
  return 0;
}

static int parse_seed(uint64_t *seed, const char *text, const complaint *c) {
  char *end;
  errno = 0;
  *seed = strtoull(text, &end, 10);
  if (end == text || *end || errno || text[0] == '-') return complain(c, "--seed", "a whole number, 0 or more", text);
  return 0;
}

static int add_override(options *o, const char *text, const complaint *c) {
  if (o->override_count == MAX_OVERRIDES) return complain(c, "--set", "at most 16 of them", text);
  o->overrides[o->override_count++] = text;
  return 0;
}

static int parse_option(options *o, const char *name, const char *value, const complaint *c) {
  if (strcmp(name, "--trace") != 0 && strcmp(name, "--directory") != 0 && strcmp(name, "--replay") != 0)
    o->run_option = name;
  if (strcmp(name, "--speed") == 0 || strcmp(name, "--record") == 0) o->paced_option = name;
  if (strcmp(name, "--duration") == 0) return parse_positive(&o->duration_s, name, value, c);
  if (strcmp(name, "--speed") == 0) return parse_speed(&o->speed, value, c);
  if (strcmp(name, "--seed") == 0) return parse_seed(&o->seed, value, c);
  if (strcmp(name, "--set") == 0) return add_override(o, value, c);
  if (strcmp(name, "--trace") == 0)
    o->trace_path = value;
  else if (strcmp(name, "--control") == 0)
    o->control_path = value;
  else if (strcmp(name, "--keys") == 0)
    o->keys_path = value;
  else if (strcmp(name, "--record") == 0)
    o->record_path = value;
  else if (strcmp(name, "--replay") == 0)
    o->replay_path = value;
  else
    o->directory = value;
  return 0;
}

static int check_name(const char *name, const complaint *c) {
  for (int i = 0; NAMES[i]; i++)
    if (strcmp(name, NAMES[i]) == 0) return 0;
  const char *near = suggest(name, NAMES);
  snprintf(c->error, c->size, "unknown option %.60s%s%s; try --help", name, near ? "; did you mean " : "",
           near ? near : "");
  return -1;
}

static int take_scenario(options *o, const char *path, const complaint *c) {
  if (o->scenario) return complain(c, "scenario", "one file", path);
  o->scenario = path;
  return 0;
}

int options_parse(options *o, int argc, char **argv, char *error, size_t error_size) {
  complaint c = {error, error_size};
  *o = (options){.directory = ".", .speed = 1, .seed = 1};
  for (int i = 1; i < argc; i++) {
    const char *argument = argv[i];
    if (argument[0] != '-') {
      if (take_scenario(o, argument, &c) != 0) return -1;
      continue;
    }
    if (check_name(argument, &c) != 0) return -1;
    if (strcmp(argument, "--help") == 0) {
      o->help = true;
      return 0;
    }
    if (strcmp(argument, "--lockstep") == 0) {
      o->lockstep = true;
      o->run_option = argument;
      continue;
    }
    if (i + 1 == argc) {
      snprintf(error, error_size, "%s needs a value after it; try --help", argument);
      return -1;
    }
    if (parse_option(o, argument, argv[++i], &c) != 0) return -1;
  }
  if (!o->scenario) {
    snprintf(error, error_size, "name a scenario file; try --help");
    return -1;
  }
  if (o->replay_path && o->run_option) {
    snprintf(error, error_size, "--replay makes the run as it was recorded; leave out %s", o->run_option);
    return -1;
  }
  if (o->lockstep && o->paced_option) {
    snprintf(error, error_size, "--lockstep has neither speed nor record; leave out %s", o->paced_option);
    return -1;
  }
  if (o->lockstep && o->trace_path && strcmp(o->trace_path, "-") == 0)
    return complain(&c, "--trace", "a file, as --lockstep answers on standard output", o->trace_path);
  return 0;
}
