// SPDX-License-Identifier: GPL-3.0-or-later
// The sleep modes of a chip: which of its clocks stop, what wakes it, and how long it takes to start. simavr knows one mode
// only, in which all goes on but the CPU. ATmega640/1280/2560 data sheet, chapter 11; ATmega328P data sheet, chapter 10.
#ifndef JAVINO_SLEEP_H
#define JAVINO_SLEEP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "model.h"

struct avr_t;

// The most timers, as simavr has.
#define SLEEP_MAX_TIMERS 64

typedef uint64_t (*sleep_timer)(struct avr_t *avr, uint64_t when, void *part);

typedef struct {
  struct avr_t *avr;
  const model *model;
  bool stopped;         // clocks are
  uint8_t mode;         // SM2…0, while they are
  bool starting;        // what woke the chip has come, and the oscillator starts
  uint64_t stopped_at;  // these in the chip's cycles
  uint64_t started_at;
  struct {
    uint64_t left;  // cycles until it is due
    sleep_timer run;
    void *part;
  } timers[SLEEP_MAX_TIMERS];  // of the parts that stand still, in the order in which they are due
  size_t timer_count;
  uint64_t masked, raised;  // interrupts that do not wake the chip, by their place in simavr's table: enabled, flag set
} sleep_clocks;

void sleep_init(sleep_clocks *s, struct avr_t *avr, const model *m);

// The program has performed SLEEP. If it has not enabled that, the chip runs on.
void sleep_begin(sleep_clocks *s);

// Whether the chip, awake as simavr has it, runs instructions: not while its oscillator starts, which begins with this.
bool sleep_is_over(sleep_clocks *s);

// The chip was reset.
void sleep_reset(sleep_clocks *s);

#endif
