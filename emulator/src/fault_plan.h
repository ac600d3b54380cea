// SPDX-License-Identifier: GPL-3.0-or-later
// When each fault of the scenario comes.
#ifndef JAVINO_FAULT_PLAN_H
#define JAVINO_FAULT_PLAN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clock.h"
#include "scenario.h"

typedef struct {
  const fault_config *config;
  cycles_t at;           // NEVER while it waits for its pin
  uint64_t writes_left;  // EEPROM writes after `at` until it comes, 0: at `at`
  bool done;
} planned_fault;

typedef struct {
  planned_fault *faults;
  size_t count;
  size_t waiting;  // for a pin
  cycles_t next;   // no fault is due before
} fault_plan;

// Returns 0, or -1 where the memory does not suffice.
int fault_plan_init(fault_plan *plan, const scenario *config);
void fault_plan_release(fault_plan *plan);

// Takes the earliest fault that is due by `now` out of the plan, NULL if there is none.
const fault_config *fault_plan_take(fault_plan *plan, cycles_t now);

// A board's output changed: faults may wait for it.
void fault_plan_output(fault_plan *plan, size_t board, int pin, bool level, cycles_t at);

// A board's program writes an EEPROM byte: takes the fault that comes with it, NULL if there is none.
const fault_config *fault_plan_write(fault_plan *plan, size_t board, cycles_t at);

// How many of the board's faults have not come.
uint64_t fault_plan_pending(const fault_plan *plan, size_t board);

#endif
