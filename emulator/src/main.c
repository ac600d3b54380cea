// SPDX-License-Identifier: GPL-3.0-or-later
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "control.h"
#include "emulation.h"
#include "emulation_command.h"
#include "lockstep.h"
#include "options.h"
#include "pacing.h"
#include "paths.h"
#include "record.h"
#include "replay.h"
#include "scenario.h"
#include "simulator_log.h"
#include "trace.h"

enum { EXIT_OK = 0, EXIT_RUN = 1, EXIT_USAGE = 2 };

// How often signals are looked for while nothing comes.
#define SIGNAL_TICK_MS 100

static volatile sig_atomic_t interrupted;

static void interrupt(int signal) {
  (void)signal;
  interrupted = 1;
}

static void catch_signals(void) {
  // A write that a signal breaks off would lose a line: where nobody reads the trace, it waits on.
  struct sigaction action = {.sa_handler = interrupt, .sa_flags = SA_RESTART};
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
  sigaction(SIGHUP, &action, NULL);
  action.sa_handler = SIG_IGN;  // a reader of the trace that goes away is a write error
  sigaction(SIGPIPE, &action, NULL);
}

static int complain(int status, const char *text) {
  fprintf(stderr, "javino-emulator: %s\n", text);
  return status;
}

static void report_debt(const pacing *clock, bool *reported) {
  if (clock->given_up_ns == 0 || *reported) return;
  *reported = true;
  fprintf(stderr,
          "javino-emulator: this machine cannot keep up with the speed asked for; "
          "emulated time falls behind the wall clock\n");
}

// A run, and what steers it.
typedef struct {
  emulation e;
  pacing clock;
  bool lockstep;
  control socket;
  record kept;
  const trace *out;
  FILE *keys;  // NULL: they are not written
} session;

static int perform(void *context, const char *line, size_t length, char *error, size_t error_size) {
  session *s = context;
  command c;
  int result = command_read(&c, line, length, s->e.config, error, error_size);
  if (result == 0 && s->lockstep && c.kind == COMMAND_SPEED) {
    snprintf(error, error_size, "command: there is no speed in lock-step; leave it out");
    result = -1;
  }
  if (result == 0) record_command(&s->kept, c.given);
  if (result == 0) result = emulation_command(&s->e, &c, error, error_size);
  command_release(&c);
  if (s->e.speed_asked >= 0) {
    pacing_change(&s->clock, s->e.speed_asked, s->e.now);
    emulation_hold(&s->e, s->clock.paused);
  }
  s->e.speed_asked = -1;
  return result;
}

static void wait_for_others(session *s) {
  struct pollfd descriptors[MAX_BOARDS + CONTROL_CLIENTS + 1];
  size_t count = emulation_descriptors(&s->e, descriptors);
  count += control_descriptors(&s->socket, descriptors + count);
  pacing_wait(&s->clock, descriptors, count, emulation_serial_busy(&s->e));
}

// What can no longer be written, NULL where nothing.
static const char *unwritable(const session *s) {
  if (s->out->failed) return "the trace cannot be written any more";
  if (record_failed(&s->kept)) return "the record cannot be written any more";
  return s->keys && ferror(s->keys) ? "the keys cannot be written any more" : NULL;
}

// Runs to the end. Returns an exit status.
static int run(session *s, const options *o) {
  emulation *e = &s->e;
  cycles_t end = o->duration_s > 0 ? seconds_to_cycles(o->duration_s) : NEVER;
  bool debt_reported = false;
  pacing_start(&s->clock, o->speed);
  while (!interrupted && e->now < end) {
    cycles_t due = pacing_due(&s->clock, e->now);
    bool ahead = due < e->now + PACING_SLICE;
    cycles_t until = due < end ? due : end;
    if (until > e->now) record_run(&s->kept, until);
    if (emulation_run(e, until) != 0) return complain(EXIT_RUN, e->error);
    emulation_exchange(e);
    control_exchange(&s->socket);
    if (unwritable(s)) return complain(EXIT_RUN, unwritable(s));
    report_debt(&s->clock, &debt_reported);
    if (ahead) wait_for_others(s);
  }
  return EXIT_OK;
}

static bool pass(void *context) {
  session *s = context;
  control_exchange(&s->socket);
  return !interrupted && !unwritable(s);
}

// Waits for bytes on standard input or the control socket. Returns the number of bytes that came, 0 at the end of
// input, or -1 where there are none yet.
static ssize_t wait_for_lines(session *s, char *bytes, size_t size) {
  struct pollfd descriptors[CONTROL_CLIENTS + 2] = {{STDIN_FILENO, POLLIN, 0}};
  size_t count = 1 + control_descriptors(&s->socket, descriptors + 1);
  // A signal may come before poll does.
  if (poll(descriptors, count, SIGNAL_TICK_MS) <= 0 || descriptors[0].revents == 0) return -1;
  ssize_t length = read(STDIN_FILENO, bytes, size);
  return length < 0 && errno != EAGAIN && errno != EINTR ? 0 : length;
}

// Runs as standard input says. Returns an exit status.
static int run_locked(session *s, const options *o) {
  lockstep l;
  char bytes[4096];
  lockstep_state state = LOCKSTEP_ON;
  cycles_t duration = o->duration_s > 0 ? seconds_to_cycles(o->duration_s) : NEVER;
  lockstep_init(&l, &s->e, duration, (lockstep_listener){s, perform, pass}, stdout);
  while (state == LOCKSTEP_ON && pass(s)) {
    ssize_t length = wait_for_lines(s, bytes, sizeof bytes);
    if (length > 0) state = lockstep_take(&l, bytes, (size_t)length);
    if (length == 0) state = lockstep_finish(&l);
  }
  if (state == LOCKSTEP_REFUSED) return complain(EXIT_USAGE, l.error);
  if (state == LOCKSTEP_FAILED) return complain(EXIT_RUN, l.error);
  return unwritable(s) ? complain(EXIT_RUN, unwritable(s)) : EXIT_OK;
}

// Returns the exit status, or that of a failure to end well.
static int end(emulation *e, int status) {
  if (emulation_close(e) != 0) status = complain(EXIT_RUN, e->error);
  if (simulator_log_suppressed() > 0)
    fprintf(stderr, "javino-emulator: %lu more warnings of simavr\n", simulator_log_suppressed());
  return status;
}

static FILE *open_keys(const char *path) {
  int descriptor = open_private(path, true);
  return descriptor < 0 ? NULL : fdopen(descriptor, "a");
}

// A trace, which is kept until all boards are there: a start that was refused leaves the last run's as it is.
typedef struct {
  trace out;
  char *bytes;
  size_t length;
} held_trace;

static void hold_trace(held_trace *h, const char *path) {
  *h = (held_trace){0};
  if (path) h->out.file = open_memstream(&h->bytes, &h->length);
}

static void end_trace(held_trace *h) {
  if (h->out.file && h->out.file != stdout) fclose(h->out.file);
  free(h->bytes);
}

// Writes what was kept, and from now on all at once. Returns an exit status.
static int release_trace(held_trace *h, const char *path) {
  char error[256];
  if (!path) return EXIT_OK;
  fclose(h->out.file);
  h->out.file = strcmp(path, "-") == 0 ? stdout : fopen(path, "w");
  if (h->out.file) {
    fwrite(h->bytes, 1, h->length, h->out.file);
    fflush(h->out.file);
    return EXIT_OK;
  }
  snprintf(error, sizeof error, "--trace %s: %s", path, strerror(errno));
  return complain(EXIT_USAGE, error);
}

static int emulate(const scenario *config, const options *o, held_trace *held) {
  session s;
  trace *out = &held->out;
  char error[256];
  int status = EXIT_OK;
  if (control_open(&s.socket, o->control_path, (control_listener){&s, perform}, error, sizeof error) != 0)
    return complain(EXIT_USAGE, error);
  s.kept = (record){0};
  s.keys = NULL;
  s.out = out;
  s.lockstep = o->lockstep;
  int opened = o->lockstep ? emulation_open_played(&s.e, config, o->seed, out, NULL)
                           : emulation_open(&s.e, config, o->seed, out);
  if (opened != 0) {
    status = complain(EXIT_USAGE, s.e.error);
  } else if ((status = release_trace(held, o->trace_path)) != EXIT_OK) {
    // It has been said.
  } else if (record_open(&s.kept, o->record_path) != 0) {
    snprintf(error, sizeof error, "--record %s: %s", o->record_path, private_problem());
    status = complain(EXIT_USAGE, error);
  } else if (o->keys_path && !(s.keys = open_keys(o->keys_path))) {
    snprintf(error, sizeof error, "--keys %s: %s", o->keys_path, private_problem());
    status = complain(EXIT_USAGE, error);
  } else {
    emulation_keep(&s.e, &s.kept, s.keys);
    record_start(&s.kept, &s.e, o->seed);
    status = o->lockstep ? run_locked(&s, o) : run(&s, o);
  }
  control_close(&s.socket);
  if (record_close(&s.kept) != 0) status = complain(EXIT_RUN, "the record could not be written");
  if (s.keys) fclose(s.keys);
  return end(&s.e, status);
}

// Makes a recorded run again. Returns an exit status.
static int play(scenario *config, const options *o, held_trace *held) {
  emulation e;
  trace *out = &held->out;
  replay r;
  char error[1024];
  int status = EXIT_OK, more = 1;
  if (replay_open(&r, o->replay_path, config, error, sizeof error) != 0) {
    replay_close(&r);
    return complain(EXIT_USAGE, error);
  }
  if (emulation_open_played(&e, config, r.seed, out, r.eeproms) != 0) status = complain(EXIT_USAGE, e.error);
  if (status == EXIT_OK) status = release_trace(held, o->trace_path);
  while (status == EXIT_OK && more > 0 && !interrupted) {
    more = replay_step(&r, &e, error, sizeof error);
    if (more < 0) status = complain(EXIT_RUN, error);
    if (out->failed) status = complain(EXIT_RUN, "the trace cannot be written any more");
  }
  replay_close(&r);
  return end(&e, status);
}

int main(int argc, char **argv) {
  char error[1024];
  options o;
  if (options_parse(&o, argc, argv, error, sizeof error) != 0) return complain(EXIT_USAGE, error);
  if (o.help) {
    fputs(OPTIONS_USAGE, stdout);
    return EXIT_OK;
  }
  catch_signals();
  simulator_log_install();
  scenario config;
  scenario_context context = {o.directory, o.overrides, o.override_count};
  held_trace held;
  int status;
  if (scenario_load(&config, o.scenario, &context, error, sizeof error) != 0) {
    status = complain(EXIT_USAGE, error);
  } else {
    hold_trace(&held, o.trace_path);
    status = o.replay_path ? play(&config, &o, &held) : emulate(&config, &o, &held);
    end_trace(&held);
  }
  scenario_release(&config);
  return status;
}
