// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_plan.h"

#include <stdlib.h>

static bool waits_for_time(const planned_fault *fault) { return !fault->done && fault->writes_left == 0; }

static bool matches(const planned_fault *fault, size_t board) {
  return !fault->done && fault->config->kind != FAULT_JAM && fault->config->board == board;
}

static void find_next(fault_plan *plan) {
  plan->next = NEVER;
  for (size_t i = 0; i < plan->count; i++)
    if (waits_for_time(&plan->faults[i]) && plan->faults[i].at < plan->next) plan->next = plan->faults[i].at;
}

int fault_plan_init(fault_plan *plan, const scenario *config) {
  *plan = (fault_plan){.count = config->fault_count};
  plan->faults = calloc(plan->count + 1, sizeof *plan->faults);
  if (!plan->faults) return -1;
  for (size_t i = 0; i < plan->count; i++) {
    const fault_config *fault = &config->faults[i];
    plan->faults[i].config = fault;
    plan->faults[i].at = fault->after_pin < 0 ? seconds_to_cycles(fault->t_s) : NEVER;
    plan->faults[i].writes_left = fault->eeprom_writes;
    plan->waiting += fault->after_pin >= 0;
  }
  find_next(plan);
  return 0;
}

void fault_plan_release(fault_plan *plan) { free(plan->faults); }

const fault_config *fault_plan_take(fault_plan *plan, cycles_t now) {
  if (plan->next > now) return NULL;
  for (size_t i = 0; i < plan->count; i++) {
    planned_fault *fault = &plan->faults[i];
    if (!waits_for_time(fault) || fault->at != plan->next) continue;
    fault->done = true;
    find_next(plan);
    return fault->config;
  }
  return NULL;
}

void fault_plan_output(fault_plan *plan, size_t board, int pin, bool level, cycles_t at) {
  for (size_t i = 0; plan->waiting > 0 && i < plan->count; i++) {
    planned_fault *fault = &plan->faults[i];
    if (!matches(fault, board) || fault->at != NEVER || pin != fault->config->after_pin ||
        level != fault->config->after_level)
      continue;
    fault->at = at + seconds_to_cycles(fault->config->t_s);
    plan->waiting--;
    find_next(plan);
  }
}

const fault_config *fault_plan_write(fault_plan *plan, size_t board, cycles_t at) {
  const fault_config *reached = NULL;
  for (size_t i = 0; i < plan->count; i++) {
    planned_fault *fault = &plan->faults[i];
    if (!matches(fault, board) || fault->writes_left == 0 || at < fault->at) continue;
    if (fault->writes_left > 1) {
      fault->writes_left--;
    } else if (!reached) {  // another one waits for the write after this
      fault->done = true;
      reached = fault->config;
    }
  }
  return reached;
}

uint64_t fault_plan_pending(const fault_plan *plan, size_t board) {
  uint64_t pending = 0;
  for (size_t i = 0; i < plan->count; i++) pending += matches(&plan->faults[i], board);
  return pending;
}
