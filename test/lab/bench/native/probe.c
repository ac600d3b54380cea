// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a scenario as fast as it goes and writes its trace, then what its interrupts cost the boards
// and what it cost this machine:
//   {"t":…,"board":…,"event":"interrupts","vector":…,"count":…,"cycles":…}
//   {"t":…,"event":"cpu","microseconds":…}
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <simavr/sim_avr.h>
#include <simavr/sim_interrupts.h>

#include "emulation.h"
#include "simulator_log.h"

#define VECTORS 57  // of the ATmega2560
#define SLICE (CYCLES_PER_SECOND / 1000)

// Entering a handler and RETI take 5 cycles each, which lie outside of what simavr reports.
#define ENTRY_AND_RETURN 10

typedef struct {
  struct avr_t *avr;
  uint64_t entered;
  uint32_t running;  // vector, 0: none
  uint64_t counts[VECTORS], cycles[VECTORS];
} interrupt_account;

static void interrupt_changed(struct avr_irq_t *irq, uint32_t vector, void *context) {
  (void)irq;
  interrupt_account *account = context;
  if (account->running) {
    account->counts[account->running]++;
    account->cycles[account->running] += account->avr->cycle - account->entered + ENTRY_AND_RETURN;
  }
  account->running = vector;
  account->entered = account->avr->cycle;
}

static void watch_interrupts(interrupt_account *account, struct avr_t *avr) {
  account->avr = avr;
  avr_irq_register_notify(avr_get_interrupt_irq(avr, AVR_INT_ANY) + AVR_INT_IRQ_RUNNING, interrupt_changed, account);
}

static void report_interrupts(trace *out, cycles_t now, const char *board, const interrupt_account *account) {
  for (size_t vector = 1; vector < VECTORS; vector++) {
    if (account->counts[vector] == 0) continue;
    trace_begin(out, now, board, "interrupts");
    trace_count(out, "vector", vector);
    trace_count(out, "count", account->counts[vector]);
    trace_count(out, "cycles", account->cycles[vector]);
    trace_end(out);
  }
}

static int run(emulation *e, cycles_t end, trace *out) {
  interrupt_account *accounts = calloc(e->node_count, sizeof *accounts);
  if (!accounts) return -1;
  for (size_t i = 0; i < e->node_count; i++) watch_interrupts(&accounts[i], e->nodes[i].arduino.avr);
  int result = 0;
  clock_t begun = clock();
  while (result == 0 && e->now < end) result = emulation_run(e, e->now + SLICE < end ? e->now + SLICE : end);
  double microseconds = (double)(clock() - begun) * 1e6 / CLOCKS_PER_SEC;
  for (size_t i = 0; i < e->node_count; i++) report_interrupts(out, e->now, e->nodes[i].config->name, &accounts[i]);
  trace_begin(out, e->now, NULL, "cpu");
  trace_count(out, "microseconds", (uint64_t)microseconds);
  trace_end(out);
  free(accounts);
  return result;
}

int main(int argc, char **argv) {
  if (argc != 4) {
    fputs("usage: probe SCENARIO DIRECTORY SECONDS\n", stderr);
    return 2;
  }
  simulator_log_install();
  char error[1024];
  scenario config;
  scenario_context context = {.directory = argv[2]};
  trace out = {.file = stdout};
  int status = 1;
  if (scenario_load(&config, argv[1], &context, error, sizeof error) != 0) {
    fprintf(stderr, "probe: %s\n", error);
  } else {
    emulation e;
    if (emulation_open(&e, &config, 1, &out) == 0 && run(&e, seconds_to_cycles(atof(argv[3])), &out) == 0)
      status = 0;
    else
      fprintf(stderr, "probe: %s\n", e.error);
    emulation_close(&e);
  }
  scenario_release(&config);
  return status;
}
