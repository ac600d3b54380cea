// SPDX-License-Identifier: GPL-3.0-or-later
// The `radio` part of the scenario file.
#ifndef JAVINO_SCENARIO_RADIO_H
#define JAVINO_SCENARIO_RADIO_H

#include "json_reader.h"
#include "scenario.h"

// The keys that a command may change, too.
#define RADIO_KEYS "range", "bitErrorRate", "bursts", "errorsByDistance", "shadowing", "noise", "capture", "loss"

// Reads the whole part, or the defaults where it is absent.
void radio_config_read(radio_config *radio, const json_node *node);

// Reads what `node` says of RADIO_KEYS; all else stays as it is.
void radio_change_read(radio_config *radio, const json_node *node);

// All that radio_config_read needs to read the same again; the caller's to release.
json_t *radio_config_json(const radio_config *radio);

#endif
