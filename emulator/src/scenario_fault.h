// SPDX-License-Identifier: GPL-3.0-or-later
// The `faults` part of the scenario file, and what commands have in common with it.
#ifndef JAVINO_SCENARIO_FAULT_H
#define JAVINO_SCENARIO_FAULT_H

#include "json_reader.h"
#include "scenario.h"

// The fault's name in the file.
const char *fault_name(fault_kind kind);

// Reads one fault of a scenario whose boards are known; mistakes are recorded in the reader of `node`. A fault that is to
// come at once has no keys that say when.
void fault_read(fault_config *fault, const scenario *s, const json_node *node, bool at_once);

// Reads the `board` of an object. Returns its index, or 0 after a mistake.
size_t board_read(const scenario *s, const json_node *object);

#endif
