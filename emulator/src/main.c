// SPDX-License-Identifier: GPL-3.0-or-later
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "control.h"
#include "emulation.h"
#include "emulation_command.h"
#include "options.h"
#include "pacing.h"
#include "scenario.h"
#include "simulator_log.h"
#include "trace.h"

enum { EXIT_OK = 0, EXIT_RUN = 1, EXIT_USAGE = 2 };

static volatile sig_atomic_t interrupted;

static void interrupt(int signal) {
  (void)signal;
  interrupted = 1;
}

static void catch_signals(void) {
  struct sigaction action = {.sa_handler = interrupt};
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
  control socket;
} session;

static int perform(void *context, const char *line, size_t length, char *error, size_t error_size) {
  session *s = context;
  command c;
  int result = command_read(&c, line, length, s->e.config, error, error_size);
  if (result == 0) result = emulation_command(&s->e, &c, error, error_size);
  command_release(&c);
  if (s->e.speed_asked >= 0) pacing_change(&s->clock, s->e.speed_asked, s->e.now);
  s->e.speed_asked = -1;
  return result;
}

static void wait_for_others(session *s) {
  struct pollfd descriptors[MAX_BOARDS + CONTROL_CLIENTS + 1];
  size_t count = emulation_descriptors(&s->e, descriptors);
  count += control_descriptors(&s->socket, descriptors + count);
  pacing_wait(&s->clock, descriptors, count, emulation_serial_busy(&s->e));
}

// Runs to the end. Returns an exit status.
static int run(session *s, const options *o, const trace *out) {
  emulation *e = &s->e;
  cycles_t end = o->duration_s > 0 ? seconds_to_cycles(o->duration_s) : NEVER;
  bool debt_reported = false;
  pacing_start(&s->clock, o->speed);
  while (!interrupted && e->now < end) {
    cycles_t due = pacing_due(&s->clock, e->now);
    bool ahead = due < e->now + PACING_SLICE;
    if (emulation_run(e, due < end ? due : end) != 0) return complain(EXIT_RUN, e->error);
    emulation_exchange(e);
    control_exchange(&s->socket);
    if (out->failed) return complain(EXIT_RUN, "the trace cannot be written any more");
    report_debt(&s->clock, &debt_reported);
    if (ahead) wait_for_others(s);
  }
  return EXIT_OK;
}

static int emulate(const scenario *config, const options *o, trace *out) {
  session s;
  char error[256];
  int status = EXIT_OK;
  if (control_open(&s.socket, o->control_path, (control_listener){&s, perform}, error, sizeof error) != 0)
    return complain(EXIT_USAGE, error);
  if (emulation_open(&s.e, config, o->seed, out) != 0)
    status = complain(EXIT_USAGE, s.e.error);
  else
    status = run(&s, o, out);
  control_close(&s.socket);
  if (emulation_close(&s.e) != 0) status = complain(EXIT_RUN, s.e.error);
  if (simulator_log_suppressed() > 0)
    fprintf(stderr, "javino-emulator: %lu more warnings of simavr\n", simulator_log_suppressed());
  return status;
}

static int open_trace(trace *out, const char *path) {
  *out = (trace){0};
  if (path) out->file = strcmp(path, "-") == 0 ? stdout : fopen(path, "w");
  return path && !out->file ? -1 : 0;
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
  trace out;
  int status;
  if (scenario_load(&config, o.scenario, &context, error, sizeof error) != 0) {
    status = complain(EXIT_USAGE, error);
  } else if (open_trace(&out, o.trace_path) != 0) {
    snprintf(error, sizeof error, "--trace %s: %s", o.trace_path, strerror(errno));
    status = complain(EXIT_USAGE, error);
  } else {
    status = emulate(&config, &o, &out);
    if (out.file && out.file != stdout) fclose(out.file);
  }
  scenario_release(&config);
  return status;
}
