// SPDX-License-Identifier: GPL-3.0-or-later
// simavr's messages: warnings go to standard error, one line each; the rest goes nowhere.
#ifndef JAVINO_SIMULATOR_LOG_H
#define JAVINO_SIMULATOR_LOG_H

// The most warnings that are printed; the others are counted.
#define SIMULATOR_LOG_MAX 20

void simulator_log_install(void);

// How many warnings were not printed.
unsigned long simulator_log_suppressed(void);

#endif
