// SPDX-License-Identifier: GPL-3.0-or-later
// The first event of a trace: what is emulated.
#ifndef JAVINO_SCENARIO_EVENT_H
#define JAVINO_SCENARIO_EVENT_H

#include <stdint.h>

#include "scenario.h"
#include "trace.h"

void scenario_event_write(trace *out, const scenario *s, uint64_t seed);

#endif
